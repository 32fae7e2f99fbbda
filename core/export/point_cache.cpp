// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/point_cache.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/growing_file.h"
#include "core/files/write_model.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <set>

namespace trivar {
namespace {

// Appends the bytes of a number in big-endian or little-endian order.
void put_number(std::string& out, std::uint32_t bits, bool big)
{
    for (int i = 0; i < 4; ++i)
        out.push_back(static_cast<char>(bits >> (8 * (big ? 3 - i : i)) & 0xff));
}
void put_number(std::string& out, float value, bool big)
{
    put_number(out, std::bit_cast<std::uint32_t>(value), big);
}

struct CachedObject {
    std::string name;
    std::vector<const FilmStrip*> strips;
};

std::vector<CachedObject> objects_of(const Film& film)
{
    std::vector<CachedObject> out;
    std::set<std::string> taken;
    Id last = 0;
    for (const FilmStrip& strip : film.strips) {
        if (strip.piece > 0)
            throw Rejected(fmt::format("{}: its triangles change, and a point cache holds one mesh "
                                       "only; export it as .glb or .usda",
                                       printable(strip.name)));
        if (strip.object != last) {
            std::string name;
            for (const char c : strip.name)
                name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
            if (name.empty() || !taken.insert(name).second)
                name += fmt::format("_{}", strip.object);
            taken.insert(name);
            out.push_back({name, {}});
        }
        last = strip.object;
        out.back().strips.push_back(&strip);
    }
    return out;
}

const Part& shown_at(const FilmStrip& strip, std::size_t moment)
{
    for (std::size_t i = moment + 1; i-- > 0;)
        if (strip.shown[i]) return *strip.shown[i];
    return strip.first();
}

// A CachedMesh is an object as one mesh, Z up, with the vertices that are in the cache: the first
// one of each point, as in an OBJ file.
struct CachedMesh {
    Model model;
    std::vector<std::vector<std::uint32_t>> vertices; // by strip
};

CachedMesh cached_mesh(const CachedObject& object)
{
    CachedMesh out;
    Mesh all;
    for (const FilmStrip* strip : object.strips) {
        const Mesh mesh = mesh_in_world(shown_at(*strip, 0));
        std::vector<std::uint32_t> place_of(mesh.vertex_count()), first;
        constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> known(mesh.vertex_count() ? point_count(mesh) : 0, none);
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            std::uint32_t& place = known[mesh.point(v)];
            if (place == none || mesh.positions[first[place]] != mesh.positions[v]) {
                place = static_cast<std::uint32_t>(first.size());
                first.push_back(v);
            }
            place_of[v] = place;
        }
        const auto begin = static_cast<std::uint32_t>(all.positions.size());
        for (const std::uint32_t v : first) all.positions.push_back(mesh.positions[v]);
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            std::vector<std::uint32_t> corners;
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
                corners.push_back(begin + place_of[mesh.corners[c]]);
            add_face(all, corners);
        }
        out.vertices.push_back(std::move(first));
    }
    out.model = single_mesh_model(object.name, std::move(all));
    return out;
}

std::string header(CacheFormat format, std::size_t points, const Film& film, double per_second)
{
    const auto count = static_cast<std::uint32_t>(points),
               frames = static_cast<std::uint32_t>(film.moments.size());
    std::string out;
    if (format == CacheFormat::pc2) {
        out.assign("POINTCACHE2\0", 12);
        put_number(out, std::uint32_t{1}, false);
        put_number(out, count, false);
        put_number(out, static_cast<float>(film.moments.front()), false);
        put_number(out, 1.0f, false); // frames per sample
        put_number(out, frames, false);
        return out;
    }
    put_number(out, frames, true);
    put_number(out, count, true);
    for (const double frame : film.moments)
        put_number(out, static_cast<float>((frame - film.moments.front()) / per_second), true);
    return out;
}

} // namespace

std::vector<std::string> write_caches(const Film& film, CacheFormat format,
                                      double frames_per_second, const std::string& path,
                                      const Progress& progress, const SourceFiles& sources)
{
    const std::filesystem::path target(path);
    const std::string extension = format == CacheFormat::pc2 ? ".pc2" : ".mdd";
    const std::vector<CachedObject> objects = objects_of(film);
    if (objects.empty()) throw Rejected(path + ": there is nothing visible to write");
    const auto name_of = [&](const CachedObject& object) {
        return (target.parent_path() / (target.stem().string() + "." + object.name)).string();
    };
    for (const CachedObject& object : objects) // an .obj file has a material library beside it
        for (const char* ending : {extension.c_str(), ".obj", ".mtl"})
            sources.check(name_of(object) + ending);
    struct MadeCache {
        std::string name;
        std::unique_ptr<GrowingFile> cache;
        Model first;
    };
    std::vector<MadeCache> made;
    constexpr std::size_t most_open = 200; // of the some 1,000 files a program may open
    for (std::size_t o = 0; o < objects.size(); ++o) {
        CachedMesh cached = cached_mesh(objects[o]);
        const std::string name = name_of(objects[o]);
        auto cache = std::make_unique<GrowingFile>(name + extension);
        GrowingFile& file = *cache;
        file.append(
            header(format, cached.model.meshes.front()->vertex_count(), film, frames_per_second));
        for (std::size_t i = 0; i < film.moments.size(); ++i) {
            const auto done = static_cast<double>(o * film.moments.size() + i),
                       all = static_cast<double>(objects.size() * film.moments.size());
            report(progress, done / all, "writing places");
            std::string places;
            for (std::size_t s = 0; s < objects[o].strips.size(); ++s) {
                const Mesh mesh = mesh_in_world(shown_at(*objects[o].strips[s], i));
                for (const std::uint32_t v : cached.vertices[s]) {
                    const glm::vec3& p = mesh.positions[v];
                    for (const float value : {p.x, p.z, 0 - p.y})
                        put_number(places, value, format == CacheFormat::mdd);
                }
            }
            file.append(places);
        }
        objects.size() > most_open ? file.close() : file.settle();
        made.push_back({name, std::move(cache), std::move(cached.model)});
    }
    std::vector<std::string> out; // all files, or none if the export was stopped
    for (MadeCache& each : made) {
        write_model(each.first, each.name + ".obj");
        each.cache->finish();
        out.push_back(each.name + extension);
    }
    return out;
}

} // namespace trivar
