// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/files/color.h"
#include "core/files/file_bytes.h"
#include "core/files/formats.h"
#include "core/files/obj_blocks.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

constexpr std::size_t block_bytes = 1 << 20;

// Stretches of whole lines, each about block_bytes long.
std::vector<std::string_view> split(std::string_view text)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        std::size_t end = text.size();
        if (end > block_bytes) {
            const std::size_t line_end = text.find('\n', block_bytes);
            if (line_end != text.npos) end = line_end + 1;
        }
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return parts;
}

std::vector<ObjBlock> read_blocks(const FileText& file, std::string_view text,
                                  const Progress& progress)
{
    const std::vector<std::string_view> parts = split(text);
    std::vector<ObjBlock> blocks(parts.size());
    const std::size_t batch = 16;
    for (std::size_t first = 0; first < parts.size(); first += batch) {
        report(progress, 0.7 * double(first) / double(parts.size()), "Reading");
        const std::size_t count = std::min(batch, parts.size() - first);
        parallel_blocks(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                blocks[first + i] = read_obj_block(parts[first + i]);
        });
        for (std::size_t i = first; i < first + count; ++i)
            if (!blocks[i].error.empty()) {
                const auto line = 1 + std::count(text.data(), blocks[i].error_at, '\n');
                throw Rejected(fmt::format("{}: line {}: {}", file.name, line, blocks[i].error));
            }
    }
    return blocks;
}

template <class T>
std::vector<T> joined(std::vector<ObjBlock>& blocks, std::vector<T> ObjBlock::*member)
{
    std::size_t size = 0;
    for (const ObjBlock& block : blocks) size += (block.*member).size();
    std::vector<T> all;
    all.reserve(size);
    for (ObjBlock& block : blocks) {
        all.insert(all.end(), (block.*member).begin(), (block.*member).end());
        (block.*member) = {};
    }
    return all;
}

std::int32_t resolved(std::int32_t index, std::size_t base, std::size_t count, const char* what,
                      const FileText& file)
{
    if (index == -1) return -1;
    std::int64_t absolute = index;
    if (index >= ObjCorner::limit)
        absolute = static_cast<std::int64_t>(base) + index - ObjCorner::relative;
    if (absolute < 0 || absolute >= static_cast<std::int64_t>(count))
        throw Rejected(fmt::format("{}: a face asks for {} {}, there are {}", file.name, what,
                                   absolute + 1, count));
    return static_cast<std::int32_t>(absolute);
}

// Makes every corner's indices absolute. Faces may come before the elements they name.
std::vector<ObjCorner> resolve_corners(std::vector<ObjBlock>& blocks, std::size_t v_count,
                                       std::size_t vt_count, std::size_t vn_count,
                                       const FileText& file)
{
    std::size_t v = 0, vt = 0, vn = 0;
    for (ObjBlock& block : blocks) {
        for (ObjCorner& corner : block.corners) {
            corner.v = resolved(corner.v, v, v_count, "vertex", file);
            corner.vt = resolved(corner.vt, vt, vt_count, "texture coordinate", file);
            corner.vn = resolved(corner.vn, vn, vn_count, "normal", file);
        }
        v += block.v.size();
        vt += block.vt.size();
        vn += block.vn.size();
    }
    return joined(blocks, &ObjBlock::corners);
}

// Every different (v, vt, vn) is one vertex of the mesh, in the order of the file's v.
struct Vertices {
    std::vector<ObjCorner> of;           // #V
    std::vector<std::uint32_t> corners;  // #C to vertex
    std::vector<std::uint32_t> first_of; // #v + 1: the first vertex at each v
};

Vertices unify(const std::vector<ObjCorner>& corners, std::size_t v_count)
{
    std::vector<std::uint32_t> begin(v_count + 1, 0);
    for (const ObjCorner& c : corners) ++begin[static_cast<std::size_t>(c.v) + 1];
    for (std::size_t v = 0; v < v_count; ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> at(corners.size());
    {
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::uint32_t c = 0; c < corners.size(); ++c)
            at[next[static_cast<std::size_t>(corners[c].v)]++] = c;
    }
    const auto key = [&](std::uint32_t c) { return std::pair(corners[c].vt, corners[c].vn); };
    parallel_blocks(v_count, 1 << 14, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v)
            std::sort(at.begin() + begin[v], at.begin() + begin[v + 1],
                      [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    });
    Vertices vertices;
    vertices.corners.resize(corners.size());
    vertices.first_of.resize(v_count + 1);
    for (std::size_t v = 0; v < v_count; ++v) {
        vertices.first_of[v] = static_cast<std::uint32_t>(vertices.of.size());
        for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
            if (i == begin[v] || key(at[i]) != key(at[i - 1]))
                vertices.of.push_back(corners[at[i]]);
            vertices.corners[at[i]] = static_cast<std::uint32_t>(vertices.of.size() - 1);
        }
    }
    vertices.first_of[v_count] = static_cast<std::uint32_t>(vertices.of.size());
    return vertices;
}

void fill_attributes(Mesh& mesh, const Vertices& vertices, const std::vector<glm::vec3>& v,
                     const std::vector<glm::vec3>& colors, const std::vector<glm::vec2>& vt,
                     const std::vector<glm::vec3>& vn)
{
    const std::size_t count = vertices.of.size();
    const auto any = [&](std::int32_t ObjCorner::*index) {
        return std::any_of(vertices.of.begin(), vertices.of.end(),
                           [&](const ObjCorner& c) { return c.*index >= 0; });
    };
    mesh.positions.resize(count);
    mesh.points.resize(count);
    if (any(&ObjCorner::vt)) mesh.uvs.emplace_back(count, glm::vec2(0));
    // (0, 0, 0) says that the file gives no normal here.
    if (any(&ObjCorner::vn)) mesh.normals.assign(count, glm::vec3(0));
    if (!colors.empty()) mesh.colors.resize(count);
    std::uint32_t point = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ObjCorner& c = vertices.of[i];
        const auto at = static_cast<std::size_t>(c.v);
        if (i > 0 && vertices.of[i - 1].v != c.v) ++point;
        mesh.points[i] = point;
        mesh.positions[i] = v[at];
        if (c.vt >= 0) mesh.uvs[0][i] = vt[static_cast<std::size_t>(c.vt)];
        if (c.vn >= 0) mesh.normals[i] = vn[static_cast<std::size_t>(c.vn)];
        if (!colors.empty()) mesh.colors[i] = glm::vec4(linear_from_srgb(colors[at]), 1);
    }
}

// Follows the statements between the faces.
class Attributes {
public:
    Attributes(const FileText& file, Mesh& mesh, Model& model)
        : file_(file),
          mesh_(mesh),
          model_(model)
    {
    }

    // Libraries first: some files name them after their use.
    void read_libraries(const std::vector<ObjBlock>& blocks)
    {
        for (const ObjBlock& block : blocks)
            for (const ObjEvent& event : block.events)
                if (event.kind == ObjEvent::Kind::library) read_library(std::string(event.text));
    }

    void apply(const ObjBlock& block, const std::vector<std::uint32_t>& first_of)
    {
        std::size_t next = 0;
        for (std::uint32_t face = 0; face <= block.face_end.size(); ++face) {
            for (; next < block.events.size() && block.events[next].face == face; ++next)
                handle(block.events[next], first_of);
            if (face == block.face_end.size()) break;
            if (group_ == none && group_named_) group_ = group(group_name_);
            mesh_.face_material.push_back(material_);
            mesh_.face_group.push_back(group_);
        }
    }

    void finish()
    {
        const auto unset = [](std::uint32_t i) { return i == none; };
        auto& materials = mesh_.face_material;
        if (model_.materials.empty()) {
            materials.clear();
        } else if (std::any_of(materials.begin(), materials.end(), unset)) {
            std::replace(materials.begin(), materials.end(), none,
                         static_cast<std::uint32_t>(model_.materials.size()));
            model_.materials.emplace_back();
        }
        auto& groups = mesh_.face_group;
        if (mesh_.group_names.empty()) {
            groups.clear();
        } else if (std::any_of(groups.begin(), groups.end(), unset)) {
            std::replace(groups.begin(), groups.end(), none,
                         static_cast<std::uint32_t>(mesh_.group_names.size()));
            mesh_.group_names.emplace_back("default");
        }
    }

private:
    static constexpr std::uint32_t none = ~0u;

    void read_library(const std::string& name)
    {
        if (!libraries_.emplace(name, 0).second) return;
        const auto path = file_inside(file_.folder, name);
        if (!path) {
            model_.notices.push_back(
                fmt::format("{}: the material library {} is not in its folder", file_.name, name));
            return;
        }
        const std::string bytes = read_bytes(*path, max_mtl_bytes);
        Mtl mtl = read_mtl({bytes, name, file_.folder});
        for (Material& material : mtl.materials) {
            const auto index = static_cast<std::uint32_t>(model_.materials.size());
            if (materials_.emplace(material.name, index).second)
                model_.materials.push_back(std::move(material));
        }
        model_.notices.insert(model_.notices.end(), mtl.notices.begin(), mtl.notices.end());
    }

    void handle(const ObjEvent& event, const std::vector<std::uint32_t>& first_of)
    {
        using Kind = ObjEvent::Kind;
        if (event.kind == Kind::material) material_ = material(std::string(event.text));
        if (event.kind == Kind::group || event.kind == Kind::object) {
            // Listed when a face comes: an object's name is often followed by its groups' at once.
            group_name_ = event.text;
            group_named_ = true;
            group_ = none;
        }
        if (event.kind == Kind::tag) add_tag(event.text, first_of);
    }

    std::uint32_t material(const std::string& name)
    {
        const auto next = static_cast<std::uint32_t>(model_.materials.size());
        const auto [at, added] = materials_.emplace(name, next);
        if (added) {
            model_.notices.push_back(
                fmt::format("{}: the material {} is used and not defined", file_.name, name));
            model_.materials.emplace_back().name = name;
        }
        return at->second;
    }

    std::uint32_t group(const std::string& name)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.group_names.size());
        const auto [at, added] = groups_.emplace(name, next);
        if (added) mesh_.group_names.push_back(name);
        return at->second;
    }

    // OpenSubdiv's tags: crease 2/1/0 A B SHARPNESS and corner 1/1/0 A SHARPNESS, v from 0.
    void add_tag(std::string_view text, const std::vector<std::uint32_t>& first_of)
    {
        TextScan scan(text);
        const std::string_view kind = scan.word();
        if (kind != "crease" && kind != "corner") return;
        scan.word();
        std::uint32_t ends[2]{};
        for (int i = 0; i < (kind == "crease" ? 2 : 1); ++i) {
            scan.skip_blanks();
            const auto v = scan.integer();
            if (!v || *v < 0 || static_cast<std::size_t>(*v) + 1 >= first_of.size())
                throw Rejected(
                    fmt::format("{}: a {} tag names a vertex that is not there", file_.name, kind));
            const auto at = static_cast<std::size_t>(*v);
            if (first_of[at] == first_of[at + 1]) return; // no face has it
            ends[i] = first_of[at];
            if (kind == "corner") ends[1] = ends[0];
        }
        const auto sharpness = scan.number();
        if (!sharpness || *sharpness < 0)
            throw Rejected(
                fmt::format("{}: a {} tag has no sharpness from 0 up", file_.name, kind));
        mesh_.creases.push_back({ends[0], ends[1], static_cast<float>(*sharpness)});
    }

    static constexpr std::uintmax_t max_mtl_bytes = 64 << 20;
    const FileText& file_;
    Mesh& mesh_;
    Model& model_;
    std::map<std::string, std::uint32_t> materials_, groups_;
    std::map<std::string, int> libraries_;
    std::uint32_t material_ = none, group_ = none;
    std::string group_name_;
    bool group_named_ = false;
};

// A backslash at the end of a line carries it on; blanks in their place keep every offset.
std::string without_continuations(std::string_view text)
{
    std::string result(text);
    for (std::size_t i = 0; (i = result.find('\\', i)) != result.npos; ++i) {
        std::size_t end = i + 1;
        if (end < result.size() && result[end] == '\r') ++end;
        if (end < result.size() && result[end] == '\n')
            std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(i), end + 1 - i, ' ');
    }
    return result;
}

} // namespace

Model read_obj(const FileText& file, const Progress& progress)
{
    std::string plain;
    std::string_view text = file.bytes;
    if (text.find("\\\n") != text.npos || text.find("\\\r\n") != text.npos)
        text = plain = without_continuations(text);
    std::vector<ObjBlock> blocks = read_blocks(file, text, progress);

    report(progress, 0.7, "Joining vertices");
    std::size_t v_count = 0, vt_count = 0, vn_count = 0;
    std::size_t left_out = 0, free_forms = 0;
    bool colored = false;
    for (const ObjBlock& block : blocks) {
        v_count += block.v.size();
        vt_count += block.vt.size();
        vn_count += block.vn.size();
        left_out += block.lines_and_points;
        free_forms += block.free_forms;
        colored |= !block.colors.empty();
    }
    if (colored)
        for (ObjBlock& block : blocks) block.colors.resize(block.v.size(), glm::vec3(1));

    Model model;
    Mesh mesh;
    for (const ObjBlock& block : blocks) {
        const auto first = mesh.face_begin.back();
        for (const std::uint32_t end : block.face_end) mesh.face_begin.push_back(first + end);
    }
    const std::vector<ObjCorner> corners =
        resolve_corners(blocks, v_count, vt_count, vn_count, file);
    Vertices vertices = unify(corners, v_count);
    const auto v = joined(blocks, &ObjBlock::v), vn = joined(blocks, &ObjBlock::vn),
               colors = joined(blocks, &ObjBlock::colors);
    fill_attributes(mesh, vertices, v, colors, joined(blocks, &ObjBlock::vt), vn);
    mesh.corners = std::move(vertices.corners);

    report(progress, 0.85, "Reading materials");
    Attributes attributes(file, mesh, model);
    attributes.read_libraries(blocks);
    for (const ObjBlock& block : blocks) attributes.apply(block, vertices.first_of);
    attributes.finish();
    if (left_out > 0)
        model.notices.push_back(
            fmt::format("{}: {} lines and points were left out", file.name, left_out));
    if (free_forms > 0)
        model.notices.push_back(fmt::format("{}: {} free-form curves and surfaces were left out",
                                            file.name, free_forms));
    model.meshes = {make_ref(std::move(mesh))};
    model.nodes = {Node{"", -1, glm::dmat4(1), 0}};
    return model;
}

} // namespace trivar
