// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.h"

#include "core/base/finite.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <tuple>

namespace trivar {
namespace {

template <class T>
void check_values(const std::vector<T>& values, std::size_t expected, bool may_be_empty,
                  const char* what, const std::string& name)
{
    if (values.empty() && may_be_empty) return;
    if (values.size() != expected)
        throw Rejected(
            fmt::format("{}: {} {} for {} vertices", name, values.size(), what, expected));
    for (std::size_t v = 0; v < values.size(); ++v)
        if (!finite(values[v]))
            throw Rejected(
                fmt::format("{}: vertex {} has a value among its {} that is not a finite "
                            "number",
                            name, v, what));
}

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t expected,
                   std::size_t limit, const char* what, const std::string& name)
{
    if (!indices.empty() && indices.size() != expected)
        throw Rejected(fmt::format("{}: {} {}, expected {}", name, indices.size(), what, expected));
    for (const std::uint32_t index : indices)
        if (index >= limit)
            throw Rejected(fmt::format("{}: one of the {} is {}, but there are only {}", name, what,
                                       index, limit));
}

// Finds the first vertex at the position of each vertex, by sorting.
std::vector<std::uint32_t> first_by_sorting(const std::vector<glm::vec3>& positions)
{
    std::vector<std::uint32_t> order(positions.size()), first(positions.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
    const auto key = [&](std::uint32_t v) {
        const glm::vec3& p = positions[v];
        return std::tuple(p.x, p.y, p.z, v);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

// Finds the same by a hash with open addressing; none if it takes too many probes, because
// positions may have been chosen to collide.
std::vector<std::uint32_t> first_by_hash(const std::vector<glm::vec3>& positions)
{
    const std::uint32_t none = ~0u;
    const std::size_t slots = std::bit_ceil(positions.size() * 2 + 1);
    std::size_t probes_left = 64 * positions.size();
    std::vector<std::uint32_t> first_at(slots, none), first(positions.size());
    const auto slot_of = [&](const glm::vec3& position) {
        const glm::vec3 p = position + 0.0f; // -0 and 0 are one position
        std::uint64_t hash = 0;
        for (int i = 0; i < 3; ++i) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(p[i])) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash & (slots - 1));
    };
    constexpr std::size_t together = 16; // slots that are fetched from memory before they are used
    std::array<std::size_t, together> fetched{};
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        if (v % together == 0)
            for (std::size_t i = v; i < std::min(v + together, positions.size()); ++i) {
                fetched[i % together] = slot_of(positions[i]);
                __builtin_prefetch(&first_at[fetched[i % together]]);
            }
        std::size_t slot = fetched[v % together];
        while (first_at[slot] != none && positions[first_at[slot]] != positions[v]) {
            if (probes_left-- == 0) return {};
            slot = (slot + 1) & (slots - 1);
        }
        if (first_at[slot] == none) first_at[slot] = v;
        first[v] = first_at[slot];
    }
    return first;
}

// Numbers the points from 0 in the order of first appearance, so that the mesh is the same as one
// made without the vertices that were removed.
void renumber_points(std::vector<std::uint32_t>& points, std::size_t count_before)
{
    const std::uint32_t none = ~0u;
    std::vector<std::uint32_t> now(count_before, none);
    std::uint32_t count = 0;
    for (std::uint32_t& point : points) {
        if (now[point] == none) now[point] = count++;
        point = now[point];
    }
}

} // namespace

Box bounding_box(const Mesh& mesh, const glm::dmat4& to_world)
{
    constexpr std::size_t per_block = 1 << 14;
    std::vector<Box> boxes(mesh.vertex_count() / per_block + 1);
    parallel_blocks(mesh.vertex_count(), per_block, [&](std::size_t begin, std::size_t end) {
        Box box;
        for (std::size_t v = begin; v < end; ++v)
            box.add(glm::dvec3(to_world * glm::dvec4(mesh.positions[v], 1)));
        boxes[begin / per_block] = box;
    });
    Box all;
    for (const Box& box : boxes) all.add(box);
    return all;
}

void add_face(Mesh& mesh, std::span<const std::uint32_t> vertices)
{
    mesh.corners.insert(mesh.corners.end(), vertices.begin(), vertices.end());
    mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

glm::dvec3 area_normal(const Mesh& mesh, std::size_t face)
{
    const std::uint32_t begin = mesh.face_begin[face], end = mesh.face_begin[face + 1];
    const glm::dvec3 origin(mesh.positions[mesh.corners[begin]]);
    glm::dvec3 sum(0);
    for (std::uint32_t c = begin + 1; c + 1 < end; ++c)
        sum += glm::cross(glm::dvec3(mesh.positions[mesh.corners[c]]) - origin,
                          glm::dvec3(mesh.positions[mesh.corners[c + 1]]) - origin);
    return sum;
}

std::vector<std::uint32_t> points_by_position(const std::vector<glm::vec3>& positions)
{
    std::vector<std::uint32_t> first = first_by_hash(positions);
    if (first.empty() && !positions.empty()) first = first_by_sorting(positions);
    std::vector<std::uint32_t> points(positions.size());
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < points.size(); ++v)
        points[v] = first[v] == v ? count++ : points[first[v]];
    return points;
}

std::size_t point_count(const Mesh& mesh)
{
    if (mesh.points.empty()) return mesh.vertex_count();
    return *std::max_element(mesh.points.begin(), mesh.points.end()) + std::size_t{1};
}

void take_vertices(Mesh& mesh, const std::vector<std::uint32_t>& from)
{
    const auto take = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> taken;
        taken.reserve(from.size());
        for (const std::uint32_t v : from) taken.push_back(values[v]);
        values = std::move(taken);
    };
    if (mesh.points.empty() && from.size() > mesh.vertex_count()) { // each was its own point
        mesh.points.resize(mesh.vertex_count());
        std::iota(mesh.points.begin(), mesh.points.end(), 0u);
    }
    if (!mesh.creases.empty()) {
        std::vector<std::uint32_t> first_of(mesh.vertex_count());
        for (std::size_t v = from.size(); v-- > 0;)
            first_of[from[v]] = static_cast<std::uint32_t>(v);
        for (Mesh::Crease& crease : mesh.creases)
            crease.a = first_of[crease.a], crease.b = first_of[crease.b];
    }
    take(mesh.points);
    take(mesh.positions);
    take(mesh.normals);
    take(mesh.tangents);
    take(mesh.colors);
    for (auto& set : mesh.uvs) take(set);
    take(mesh.influences);
    for (Mesh::MorphTarget& target : mesh.morph_targets) {
        take(target.positions);
        take(target.normals);
        take(target.tangents);
    }
}

Mesh without_loose_vertices(Mesh mesh)
{
    std::vector<bool> used(mesh.vertex_count(), false);
    for (const std::uint32_t v : mesh.corners) used[v] = true;
    std::vector<std::uint32_t> kept, now_at(mesh.vertex_count());
    for (std::uint32_t v = 0; v < used.size(); ++v) {
        now_at[v] = static_cast<std::uint32_t>(kept.size());
        if (used[v]) kept.push_back(v);
    }
    if (kept.size() == mesh.vertex_count()) return mesh;
    std::erase_if(mesh.creases, [&](const Mesh::Crease& c) { return !used[c.a] || !used[c.b]; });
    const std::size_t points = point_count(mesh);
    take_vertices(mesh, kept);
    renumber_points(mesh.points, points);
    for (std::uint32_t& v : mesh.corners) v = now_at[v];
    return mesh;
}

std::vector<glm::vec3> smooth_normals(const Mesh& mesh)
{
    std::vector<glm::dvec3> sums(mesh.vertex_count() == 0 ? 0 : point_count(mesh), glm::dvec3(0));
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 normal = area_normal(mesh, f);
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            sums[mesh.point(mesh.corners[c])] += normal;
    }
    std::vector<glm::vec3> normals(mesh.vertex_count());
    for (std::uint32_t v = 0; v < normals.size(); ++v) {
        const glm::dvec3 sum = sums[mesh.point(v)];
        const double length = glm::length(sum);
        normals[v] =
            length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : glm::vec3(0, 0, 1);
    }
    return normals;
}

void validate(const Mesh& mesh, const std::string& name)
{
    const std::size_t vertices = mesh.vertex_count(), faces = mesh.face_count();
    check_values(mesh.positions, vertices, true, "positions", name);
    check_values(mesh.normals, vertices, true, "normals", name);
    check_values(mesh.tangents, vertices, true, "tangents", name);
    check_values(mesh.colors, vertices, true, "colours", name);
    for (const auto& set : mesh.uvs)
        check_values(set, vertices, false, "texture coordinates", name);
    check_indices(mesh.points, vertices, vertices, "point numbers", name);
    if (mesh.face_begin.empty() || mesh.face_begin.front() != 0 ||
        mesh.face_begin.back() != mesh.corners.size())
        throw Rejected(name + ": the faces do not cover the corners");
    check_indices(mesh.corners, mesh.corners.size(), vertices, "corners' vertices", name);
    for (std::size_t f = 0; f < faces; ++f) {
        if (mesh.face_begin[f + 1] < mesh.face_begin[f] ||
            mesh.face_begin[f + 1] - mesh.face_begin[f] < 3)
            throw Rejected(fmt::format("{}: face {} has fewer than three corners", name, f));
    }
    check_indices(mesh.face_material, faces, ~0u, "face materials", name);
    check_indices(mesh.face_group, faces, mesh.group_names.size(), "face groups", name);
    for (const Mesh::Crease& crease : mesh.creases)
        if (crease.a >= vertices || crease.b >= vertices || !(crease.sharpness >= 0))
            throw Rejected(
                name +
                ": a crease names a vertex that does not exist, or its sharpness is below 0");
}

} // namespace trivar
