// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_mesh.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

enum : std::size_t {
    point_list = 0,
    line_list = 1,
    line_loop = 2,
    triangle_list = 4,
    triangle_strip = 5,
    triangle_fan = 6
};
constexpr std::size_t max_targets = 1024;

// Memory of a vertex and a corner in addition to their own attributes: normals, points, faces, and
// temporary data of repairs and copies.
constexpr std::size_t vertex_bytes = 40, corner_bytes = 32, line_point_bytes = 24;

// Sources are the accessors of the vertices of a primitive, by name: those of its attributes, then
// those of each target.
using Sources = std::vector<std::map<std::string, int>>;

Sources sources_of(const GltfEntry& primitive)
{
    Sources out;
    const auto add = [&](const GltfEntry& attributes) {
        auto& by_name = out.emplace_back();
        for (const std::string& name : attributes.names())
            by_name[name] = attributes.index(name.c_str());
    };
    add(primitive.needed_part("attributes"));
    primitive.each("targets", "target", add);
    return out;
}

bool is_set_beyond(const std::string& name, std::size_t uv_sets)
{
    for (std::size_t set = 0; set < uv_sets; ++set)
        if (name == fmt::format("TEXCOORD_{}", set)) return false;
    return name.starts_with("TEXCOORD_") || (name.starts_with("COLOR_") && name != "COLOR_0");
}

// Memory of the values of one vertex.
std::size_t bytes_each(const Mesh& mesh)
{
    std::size_t out = vertex_bytes + mesh.uvs.size() * sizeof(glm::vec2);
    const auto add = [&](const auto& values) { out += values.empty() ? 0 : sizeof(values[0]); };
    add(mesh.positions);
    add(mesh.colors);
    add(mesh.influences);
    for (const Mesh::MorphTarget& target : mesh.morph_targets) add(target.positions);
    return out;
}

template <class T>
void grow(std::vector<T>& values, std::size_t first, std::size_t end, const T& neutral)
{
    values.resize(first, neutral);
    values.resize(end, neutral);
}

} // namespace

GltfMeshes::GltfMeshes(GltfAccessors& accessors, CountedNotices& notices)
    : accessors_(accessors),
      notices_(notices),
      material_count_(static_cast<std::uint32_t>(accessors.file().root().count("materials")))
{
}

GltfMeshes::Shapes GltfMeshes::read(const GltfEntry& from)
{
    std::map<Sources, VertexRange> read_before, points_before;
    Mesh mesh, points;
    std::size_t flat_corners = 0; // which get vertices of their own
    FileLines lines(most_curve_points - line_points_);
    from.each("primitives", "primitive", [&](const GltfEntry& primitive) {
        const std::size_t mode = primitive.size("mode", triangle_list);
        if (mode > triangle_fan)
            primitive.fail(fmt::format("'mode' is {}, but must be from 0 to 6", mode));
        (mode == point_list ? points_left_out_ : others_) = true;
        if (mode == point_list)
            return notices_.add("one part of a mesh is points and was left out",
                                "{0} parts of meshes are points and were left out");
        const GltfEntry attributes = primitive.needed_part("attributes");
        if (!attributes.has("POSITION"))
            return notices_.add("one part of a mesh has no positions and was left out",
                                "{0} parts of meshes have no positions and were left out");
        const auto extensions = primitive.part("extensions");
        if (extensions && extensions->has("KHR_draco_mesh_compression") &&
            accessors_.zeros(attributes, "POSITION"))
            primitive.fail("it is compressed by KHR_draco_mesh_compression, which Trivar does not "
                           "support; export it without");
        // Primitives that differ only in their material share their vertices, unless a material
        // transforms texture coordinates.
        if (mode < triangle_list) {
            const auto [known, fresh] = points_before.try_emplace(sources_of(primitive));
            if (fresh) known->second = add_line_points(points, primitive);
            return add_lines(lines, primitive, mode, known->second);
        }
        Sources sources = sources_of(primitive);
        if (moves_uvs(primitive)) sources.push_back({{"material", primitive.index("material")}});
        const auto [known, fresh] = read_before.try_emplace(std::move(sources));
        if (fresh) known->second = add_vertices(mesh, primitive);
        const std::size_t before = mesh.corners.size();
        add_faces(mesh, primitive, mode, known->second);
        if (!attributes.has("NORMAL")) flat_corners += mesh.corners.size() - before;
    });
    accessors_.file().account(from, flat_corners, "corners without normals", bytes_each(mesh));
    mesh = without_loose_vertices(std::move(mesh));
    mesh.points = points_by_position(mesh.positions);
    line_points_ += lines.points();
    if (lines.without_room() > 0) notices_.say(lines_without_room(lines.without_room()));
    return {std::move(mesh), lines.curves(points.positions, points.colors)};
}

GltfAccessors::Table GltfMeshes::table(const GltfEntry& owner, const char* name, std::size_t count,
                                       std::size_t least, std::size_t most)
{
    GltfAccessors::Table out = accessors_.floats(owner, name);
    if (out.components < least || out.components > most)
        owner.fail(fmt::format("'{}' has {} numbers per vertex, but must have {}", name,
                               out.components, least));
    if (out.count != count)
        owner.fail(fmt::format("'{}' is for {} vertices, but there are {}", name,
                               with_commas(out.count), with_commas(count)));
    return out;
}

// Appends an attribute. If only some primitives of a mesh have it, the others get a neutral value.
template <class T>
void GltfMeshes::append(std::vector<T>& values, const GltfEntry& owner, const char* name,
                        VertexRange added, T neutral, std::size_t least_components)
{
    const bool there = owner.has(name);
    if (!there && values.empty()) return;
    grow(values, added.first, added.end(), neutral);
    if (!there) return;
    const GltfAccessors::Table read =
        table(owner, name, added.count, least_components, T::length());
    for (std::size_t i = 0; i < added.count; ++i)
        for (std::size_t c = 0; c < read.components; ++c)
            values[added.first + i][static_cast<int>(c)] = read.values[i * read.components + c];
    notices_.add("one value of its vertices is not a finite number and was read as 0",
                 "{0} values of its vertices are not finite numbers and were read as 0",
                 read.not_finite);
}

std::size_t GltfMeshes::position_count(const GltfEntry& attributes)
{
    const GltfAccessors::Table positions = accessors_.floats(attributes, "POSITION");
    if (positions.not_finite > 0)
        attributes.fail(fmt::format("'POSITION' has values that are not finite numbers, {} in all",
                                    with_commas(positions.not_finite)));
    return positions.count;
}

GltfMeshes::VertexRange GltfMeshes::add_vertices(Mesh& mesh, const GltfEntry& primitive)
{
    const GltfEntry attributes = primitive.needed_part("attributes");
    const VertexRange added{mesh.vertex_count(), position_count(attributes)};
    if (added.end() > 0xfffffff0u) primitive.fail("with it the mesh has too many vertices");
    accessors_.file().account(primitive, added.count, "vertices", vertex_bytes);
    append(mesh.positions, attributes, "POSITION", added, glm::vec3(0));
    append(mesh.normals, attributes, "NORMAL", added, glm::vec3(0));
    append(mesh.tangents, attributes, "TANGENT", added, glm::vec4(1, 0, 0, 1));
    append(mesh.colors, attributes, "COLOR_0", added, glm::vec4(1), 3);
    add_uvs(mesh, attributes, added, transforms_of(primitive));
    add_influences(mesh, attributes, added);
    add_targets(mesh, primitive, added);
    return added;
}

const UvTransforms& GltfMeshes::transforms_of(const GltfEntry& primitive)
{
    const int named = primitive.index("material");
    const bool there = named >= 0 && static_cast<std::uint32_t>(named) < material_count_;
    const auto [known, fresh] = transforms_.try_emplace(there ? named : -1);
    if (fresh && there)
        known->second = uv_transforms(
            accessors_.file().root().item("materials", "material", static_cast<std::size_t>(named)),
            notices_);
    return known->second;
}

bool GltfMeshes::moves_uvs(const GltfEntry& primitive)
{
    return transforms_of(primitive) != UvTransforms{};
}

void GltfMeshes::add_uvs(Mesh& mesh, const GltfEntry& attributes, VertexRange added,
                         const UvTransforms& transforms)
{
    std::size_t set = 0;
    for (; set < most_uv_sets; ++set) {
        const std::string name = fmt::format("TEXCOORD_{}", set);
        const bool there = attributes.has(name.c_str());
        if (!there && set >= mesh.uvs.size()) break;
        if (set == mesh.uvs.size()) mesh.uvs.emplace_back();
        append(mesh.uvs[set], attributes, name.c_str(), added, glm::vec2(0));
        for (std::size_t v = added.first; there && v < added.end(); ++v) {
            glm::vec2& uv = mesh.uvs[set][v];
            if (transforms[set] != UvTransform{}) uv = transforms[set](uv);
            uv.y = 1 - uv.y; // v of glTF points down
        }
    }
    const std::vector<std::string> names = attributes.names();
    if (std::ranges::any_of(names, [&](const auto& name) { return is_set_beyond(name, set); }))
        notices_.add("one part of a mesh has more colours or sets of texture coordinates than can "
                     "be read, which were left out",
                     "{0} parts of meshes have more colours or sets of texture coordinates than "
                     "can be read, which were left out");
}

void GltfMeshes::add_targets(Mesh& mesh, const GltfEntry& primitive, VertexRange added)
{
    const std::size_t count = primitive.count("targets");
    if (count > max_targets)
        primitive.fail(fmt::format("it has {} morph targets, but may have at most {}",
                                   with_commas(count), max_targets));
    mesh.morph_targets.resize(std::max(mesh.morph_targets.size(), count));
    const auto add = [&](std::vector<glm::vec3>& values, const GltfEntry& target,
                         const char* name) {
        const bool none_before = values.empty();
        if (!target.has(name) || accessors_.zeros(target, name) != added.count)
            append(values, target, name, added, glm::vec3(0));
        else if (!none_before)
            grow(values, added.first, added.end(), glm::vec3(0));
        // Differences that are all 0 are not stored.
        if (none_before && std::ranges::count(values, glm::vec3(0)) == std::ssize(values))
            values.clear();
    };
    for (std::size_t t = 0; t < mesh.morph_targets.size(); ++t) {
        Mesh::MorphTarget& to = mesh.morph_targets[t];
        if (t < count) {
            const GltfEntry target = primitive.item("targets", "target", t);
            add(to.positions, target, "POSITION");
            add(to.normals, target, "NORMAL");
            add(to.tangents, target, "TANGENT");
            continue;
        }
        for (std::vector<glm::vec3>* values : {&to.positions, &to.normals, &to.tangents})
            if (!values->empty()) grow(*values, added.first, added.end(), glm::vec3(0));
    }
}

GltfMeshes::VertexRange GltfMeshes::add_line_points(Mesh& points, const GltfEntry& primitive)
{
    const GltfEntry attributes = primitive.needed_part("attributes");
    const VertexRange added{points.vertex_count(), position_count(attributes)};
    accessors_.file().account(primitive, added.count, "points", vertex_bytes);
    append(points.positions, attributes, "POSITION", added, glm::vec3(0));
    append(points.colors, attributes, "COLOR_0", added, glm::vec4(1), 3);
    if (primitive.count("targets") > 0 || attributes.has("JOINTS_0"))
        notices_.add("one part of a mesh is lines with a skin or morph targets, which are left "
                     "out: the lines follow their node",
                     "{0} parts of meshes are lines with skins or morph targets, which are left "
                     "out: the lines follow their nodes");
    return added;
}

void GltfMeshes::add_lines(FileLines& lines, const GltfEntry& primitive, std::size_t mode,
                           VertexRange points)
{
    std::vector<std::uint32_t> order = order_of(primitive, points);
    accessors_.file().account(primitive, order.size(), "points", line_point_bytes);
    for (std::uint32_t& v : order) v += static_cast<std::uint32_t>(points.first);
    const std::uint32_t material = material_of(primitive);
    lines.interrupt();
    if (order.size() < 2 || (mode == line_list && order.size() % 2 != 0))
        notices_.add("one part of a mesh has a line with one end, which was left out",
                     "{0} parts of meshes have a line with one end, which was left out");
    if (mode == line_list) {
        for (std::size_t i = 0; i + 1 < order.size(); i += 2)
            lines.add_edge(order[i], order[i + 1], material);
    } else if (order.size() >= 2) {
        if (mode == line_loop) order.push_back(order.front());
        lines.add(order, material);
    }
}

std::vector<std::uint32_t> GltfMeshes::order_of(const GltfEntry& primitive, VertexRange vertices)
{
    if (primitive.index("indices") >= 0)
        return accessors_.indices(primitive, "indices", vertices.count);
    std::vector<std::uint32_t> order(vertices.count);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    return order;
}

void GltfMeshes::add_faces(Mesh& mesh, const GltfEntry& primitive, std::size_t mode,
                           VertexRange vertices)
{
    const std::vector<std::uint32_t> order = order_of(primitive, vertices);
    const bool listed = mode == triangle_list;
    accessors_.file().account(primitive, order.size(), "corners",
                              listed ? corner_bytes : 3 * corner_bytes);
    if (listed && order.size() % 3 != 0)
        notices_.add("one list of triangles ends within a triangle, which was left out",
                     "{0} lists of triangles end within a triangle, which was left out");
    for (std::size_t i = 0; i + 2 < order.size(); i += listed ? 3 : 1) {
        std::array triangle{order[i], order[i + 1], order[i + 2]};
        if (mode == triangle_strip && i % 2 == 1) std::swap(triangle[1], triangle[2]);
        if (mode == triangle_fan) triangle[0] = order[0];
        for (std::uint32_t& v : triangle) v += static_cast<std::uint32_t>(vertices.first);
        add_face(mesh, triangle);
    }
    mesh.face_material.resize(mesh.face_count(), material_of(primitive));
}

std::uint32_t GltfMeshes::material_of(const GltfEntry& primitive)
{
    const int named = primitive.index("material");
    if (named >= 0 && static_cast<std::uint32_t>(named) < material_count_)
        return static_cast<std::uint32_t>(named);
    if (named >= 0)
        notices_.add("one part of a mesh names a material that does not exist, and got a plain one",
                     "{0} parts of meshes name materials that do not exist, and got a plain one");
    plain_used_ = true;
    return material_count_;
}

} // namespace trivar
