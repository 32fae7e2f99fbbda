// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/usd_instances.h"

#include "core/export/usd_curves.h"
#include "core/export/usd_text.h"
#include "core/mesh/node_parts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// Rounds to the nearest number with 11 significant bits, as half precision has them up to 1.
double in_half_precision(double value)
{
    constexpr int least_power = -14, bits = 10;
    const int power = value == 0 ? least_power : std::max(std::ilogb(value), least_power);
    const double unit = std::ldexp(1.0, power - bits);
    return std::nearbyint(value / unit) * unit;
}

UsdPlace usd_place(const NodeTransform& parts)
{
    const glm::dquat& q = parts.rotation;
    return {glm::vec3(parts.translation), glm::vec4(q.x, q.y, q.z, q.w), glm::vec3(parts.scale)};
}

template <class Is> bool at_all_moments(const FilmStrip& strip, const Is& is)
{
    return std::ranges::all_of(strip.shown, [&](const Part* part) { return !part || is(*part); });
}

// Whether the same tile is repeated as many times at all moments.
bool repeats_a_tile(const FilmStrip& strip)
{
    const Part& first = strip.first();
    return first.tiles && at_all_moments(strip, [&](const Part& part) {
               return part.drawn_from_tiles() && part.tiles->model == first.tiles->model &&
                      part.tiles->tiles->size() == first.tiles->tiles->size();
           });
}

// The strip that shows one part at all moments, and else is another one.
FilmStrip with_part(const FilmStrip& strip, const Part& part)
{
    FilmStrip out = strip;
    std::ranges::fill(out.shown, &part);
    return out;
}

// Adds the tiles of a strip that stay bent, and puts the places of the others into `made`, which is
// the instancer of all strips of one part.
void add_tiles(InstancedFilm& out, UsdInstancer& made, RigidCount& counts, const FilmStrip& strip,
               double tolerance, const Progress& progress)
{
    const std::size_t count = strip.first().tiles->tiles->size();
    std::vector<double> off(count, 0);
    std::vector<std::vector<RigidTile>> tiles(strip.shown.size());
    for (std::size_t i = 0; i < strip.shown.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(strip.shown.size()),
               "fitting instances");
        const Part* part = strip.shown[i];
        if (part && i > 0 && strip.shown[i - 1] && *part == *strip.shown[i - 1])
            tiles[i] = tiles[i - 1];
        else if (part)
            tiles[i] = rigid_tiles({part}, tolerance, in_usd_precision);
        for (std::size_t t = 0; t < tiles[i].size(); ++t)
            off[t] = std::max(off[t], tiles[i][t].off_instance);
    }
    const auto is_rigid = [&](double each) { return each <= tolerance; };
    const auto rigid = static_cast<std::size_t>(std::ranges::count_if(off, is_rigid));
    for (const double each : off) {
        double& most = is_rigid(each) ? counts.off : counts.off_bent;
        if (std::isfinite(each)) most = std::max(most, each);
    }
    counts.instances = std::max(counts.instances, rigid); // tiles that grow come one after another
    counts.bent = std::max(counts.bent, count - rigid);
    if (rigid < count) {
        FilmStrip bent = strip;
        for (std::size_t i = 0; i < strip.shown.size(); ++i) {
            const Part* part = strip.shown[i];
            if (!part) continue;
            if (i > 0 && strip.shown[i - 1] && *part == *strip.shown[i - 1]) {
                bent.shown[i] = bent.shown[i - 1];
                continue;
            }
            std::vector<PlacedTile> those;
            for (std::size_t t = 0; t < count; ++t)
                if (!is_rigid(off[t])) those.push_back((*part->tiles->tiles)[t]);
            Part& made_of_them = out.parts.emplace_back();
            made_of_them.rest = make_ref(bent_tiles(*part->tiles->model->mesh, those));
            made_of_them.to_world = part->to_world;
            made_of_them.key = part->key;
            bent.shown[i] = &made_of_them;
        }
        out.strips.push_back(std::move(bent));
    }
    for (std::size_t i = 0; i < tiles.size(); ++i)
        for (std::size_t t = 0; t < tiles[i].size(); ++t)
            if (is_rigid(off[t])) made.places[i].push_back(usd_place(tiles[i][t].parts.front()));
}

// Whether two strips repeat one tile, and belong to one part: its number of tiles changes in time.
bool continues(const FilmStrip& strip, const FilmStrip& next)
{
    return next.object == strip.object && next.key == strip.key && repeats_a_tile(next) &&
           next.first().tiles->model == strip.first().tiles->model;
}

// The places of a strip that moves as a whole and is always shown, by moment; empty if it does not,
// or half precision would take a corner of its box further than the tolerance.
std::vector<UsdPlace> rigid_places(const FilmStrip& strip, double tolerance)
{
    const Part& first = strip.first();
    if (first.tiles || strip.bent() || strip.posed() || strip.reshaped()) return {};
    const Box box = bounding_box(*first.rest);
    std::vector<UsdPlace> out;
    for (const Part* part : strip.shown) {
        const std::optional<NodeTransform> parts =
            part ? as_parts(part->to_world) : std::optional<NodeTransform>();
        if (!parts || !(parts->scale.x > 0) || box.empty()) return {};
        const NodeTransform stored = in_usd_precision(*parts);
        for (const glm::dvec3& corner : box.corners()) {
            const glm::dvec4 p(corner, 1);
            if (!(glm::distance(stored.matrix() * p, part->to_world * p) <= tolerance)) return {};
        }
        out.push_back(usd_place(stored));
    }
    return out;
}

} // namespace

NodeTransform in_usd_precision(const NodeTransform& parts)
{
    NodeTransform out = in_single_precision(parts);
    for (int c = 0; c < 4; ++c) out.rotation[c] = in_half_precision(parts.rotation[c]);
    return out;
}

InstancedFilm instanced(const Film& film, double tolerance, const Progress& progress)
{
    InstancedFilm out;
    const auto count = static_cast<double>(film.strips.size());
    std::map<std::pair<Id, Ref<Mesh>>, std::vector<std::size_t>> copies; // looked up only
    std::vector<std::vector<UsdPlace>> places(film.strips.size());
    Id layer = 0; // strips are in the order of objects
    for (std::size_t s = 0; s < film.strips.size(); ++s) {
        const FilmStrip& strip = film.strips[s];
        if (repeats_a_tile(strip)) continue;
        places[s] = rigid_places(strip, tolerance);
        if (!places[s].empty()) copies[{strip.object, strip.first().rest}].push_back(s);
    }
    for (std::size_t s = 0; s < film.strips.size(); ++s) {
        const FilmStrip& strip = film.strips[s];
        if (repeats_a_tile(strip)) {
            if (strip.object == layer)
                ++out.counts.back().meshes;
            else
                out.counts.push_back({.name = strip.name});
            layer = strip.object;
            RigidCount counts;
            Part& unit = out.parts.emplace_back();
            unit.rest = strip.first().tiles->model->mesh;
            UsdInstancer made{with_part(strip, unit), {}};
            made.places.resize(film.moments.size());
            for (;; ++s) {
                const auto at = static_cast<double>(s);
                add_tiles(out, made, counts, film.strips[s], tolerance,
                          part_of(progress, at / count, (at + 1) / count));
                if (s + 1 == film.strips.size() || !continues(strip, film.strips[s + 1])) break;
            }
            RigidCount& all = out.counts.back();
            all.instances += counts.instances;
            all.bent += counts.bent;
            all.off = std::max(all.off, counts.off);
            all.off_bent = std::max(all.off_bent, counts.off_bent);
            if (counts.instances > 0) out.instancers.push_back(std::move(made));
            continue;
        }
        const std::vector<std::size_t>& same = places[s].empty()
                                                   ? std::vector<std::size_t>{}
                                                   : copies.at({strip.object, strip.first().rest});
        if (same.size() < 2) {
            out.strips.push_back(strip);
        } else if (same.front() == s) {
            Part& alone = out.parts.emplace_back();
            alone.rest = strip.first().rest;
            UsdInstancer made{with_part(strip, alone), {}};
            made.places.resize(film.moments.size());
            for (std::size_t i = 0; i < film.moments.size(); ++i)
                for (const std::size_t each : same) made.places[i].push_back(places[each][i]);
            out.instancers.push_back(std::move(made));
        }
    }
    return out;
}

void begin_instancer(GrowingFile& file, const Film& film, const UsdInstancer& of,
                     const std::string& name)
{
    const auto line = [&](const std::string& text) { file.append("        " + text + "\n"); };
    std::size_t first = 0;
    while (of.places[first].empty()) ++first;
    file.append(fmt::format("    def PointInstancer \"{}\"\n    {{\n", name));
    line(fmt::format("rel prototypes = </Scene/{0}/{0}>", name));
    const auto attribute = [&](const std::string& type, const auto& text) {
        std::vector<std::string> lists; // by moment; empty where it is not shown
        for (const std::vector<UsdPlace>& there : of.places) {
            std::string& list = lists.emplace_back();
            for (const UsdPlace& each : there) list += (list.empty() ? "[" : ", ") + text(each);
            if (!there.empty()) list += "]";
        }
        if (std::ranges::all_of(lists, [&](const std::string& list) {
                return list.empty() || list == lists[first];
            }))
            return line(type + " = " + lists[first]);
        line(type + ".timeSamples = {");
        for (std::size_t i = 0; i < lists.size(); ++i)
            if (!lists[i].empty()) line("    " + usd_time(film, i) + ": " + lists[i] + ",");
        line("}");
    };
    attribute("int[] protoIndices", [](const UsdPlace&) { return std::string("0"); });
    attribute("point3f[] positions", [](const UsdPlace& p) { return usd_tuple(p.position); });
    attribute("quath[] orientations", [](const UsdPlace& p) { // the real part comes first
        return fmt::format("({}, {}, {}, {})", usd_number(p.turn.w), usd_number(p.turn.x),
                           usd_number(p.turn.y), usd_number(p.turn.z));
    });
    attribute("float3[] scales", [](const UsdPlace& p) { return usd_tuple(p.scale); });
    if (std::ranges::none_of(of.places, &std::vector<UsdPlace>::empty)) return;
    line("token visibility.timeSamples = {");
    for (std::size_t i = 0; i < of.places.size(); ++i)
        line(fmt::format("    {}: \"{}\",", usd_time(film, i),
                         of.places[i].empty() ? "invisible" : "inherited"));
    line("}");
}

} // namespace trivar
