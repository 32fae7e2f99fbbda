// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/halve_edges.h"

#include "core/base/parallel.h"
#include "core/refinement/born_vertices.h"

#include <cassert>
#include <utility>

namespace trivar {
namespace {

constexpr std::size_t halved_per_turn = 1 << 11;

std::uint32_t corner_of(const Mesh& mesh, std::size_t face, std::size_t i)
{
    return mesh.corners[3 * face + i % 3];
}

// A triangle with marked edges, and for each edge (corner i to the next) its number among these,
// and later that of the vertex born on it; none: it is not split.
struct HalvedTriangle {
    std::uint32_t face;
    std::array<std::uint32_t, 3> middles;
};

std::vector<HalvedTriangle> triangles_at(const Mesh& mesh, std::size_t points,
                                         const EdgeNumbers& marked)
{
    std::vector<char> touched(points, 0); // ends of marked edges
    marked.for_each([&](std::uint32_t a, std::uint32_t b) { touched[a] = touched[b] = 1; });
    const auto is_touched = [&](std::size_t f, std::size_t i) {
        return touched[mesh.point(corner_of(mesh, f, i))] != 0;
    };
    std::vector<std::vector<HalvedTriangle>> found(mesh.face_count() / halved_per_turn + 1);
    parallel_blocks(mesh.face_count(), halved_per_turn, [&](std::size_t begin, std::size_t end) {
        std::vector<HalvedTriangle>& out = found[begin / halved_per_turn];
        for (std::size_t f = begin; f < end; ++f) {
            if (is_touched(f, 0) + is_touched(f, 1) + is_touched(f, 2) < 2) continue;
            HalvedTriangle each{static_cast<std::uint32_t>(f), {}};
            bool any = false;
            for (std::size_t i = 0; i < 3; ++i) {
                each.middles[i] = is_touched(f, i) && is_touched(f, i + 1)
                                      ? marked.number(mesh.point(corner_of(mesh, f, i)),
                                                      mesh.point(corner_of(mesh, f, i + 1)))
                                      : EdgeNumbers::none;
                any |= each.middles[i] != EdgeNumbers::none;
            }
            if (any) out.push_back(each);
        }
    });
    std::vector<HalvedTriangle> all;
    for (const std::vector<HalvedTriangle>& each : found)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

// Gives every edge of vertices that is split its new vertex, and the triangles the numbers of these
// among the new ones. On a seam several edges of vertices are one edge of points.
std::vector<BornVertex> middles_of(std::vector<HalvedTriangle>& halved, const Mesh& mesh,
                                   std::size_t points, std::uint32_t marked_count)
{
    // By edge of points, the first edge of vertices on it; others are on seams
    std::vector<std::uint32_t> first_born(marked_count, EdgeNumbers::none);
    EdgeNumbers others;
    std::vector<std::uint32_t> born_of_other;
    std::vector<BornVertex> born;
    born.reserve(marked_count + 64);
    for (HalvedTriangle& each : halved)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t number = each.middles[i];
            if (number == EdgeNumbers::none) continue;
            std::uint32_t a = corner_of(mesh, each.face, i);
            std::uint32_t b = corner_of(mesh, each.face, i + 1);
            if (mesh.point(b) < mesh.point(a)) std::swap(a, b); // alike for both its triangles
            std::uint32_t* known = &first_born[number];
            if (*known != EdgeNumbers::none && (born[*known].a != a || born[*known].b != b)) {
                const std::uint32_t other = others.add(a, b);
                if (other == born_of_other.size()) born_of_other.push_back(EdgeNumbers::none);
                known = &born_of_other[other];
            }
            if (*known == EdgeNumbers::none) {
                *known = static_cast<std::uint32_t>(born.size());
                born.push_back({a, b, 0.5f, static_cast<std::uint32_t>(points) + number});
            }
            each.middles[i] = *known;
        }
    return born;
}

struct TriangleParts {
    int count = 0;
    std::array<glm::uvec3, 4> parts;
};

double distance_between(const Mesh& mesh, std::uint32_t a, std::uint32_t b)
{
    return glm::distance(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]));
}

// The first of the parts takes the triangle's place.
TriangleParts parts_of(const HalvedTriangle& halved, const Mesh& mesh, std::uint32_t first_vertex)
{
    const auto is_split = [&](std::size_t i) { return halved.middles[i % 3] != EdgeNumbers::none; };
    const int count = is_split(0) + is_split(1) + is_split(2);
    std::size_t turn = 0; // so that the split edges are the first ones
    while (!is_split(turn) || (count == 2 && !is_split(turn + 1))) ++turn;
    const std::uint32_t a = corner_of(mesh, halved.face, turn),
                        b = corner_of(mesh, halved.face, turn + 1),
                        c = corner_of(mesh, halved.face, turn + 2);
    const auto middle = [&](std::size_t i) {
        return first_vertex + halved.middles[(turn + i) % 3];
    };
    const std::uint32_t ab = middle(0), bc = middle(1), ca = middle(2); // read where they are split
    if (count == 1) return {2, {{{a, ab, c}, {ab, b, c}}}};
    if (count == 3) return {4, {{{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}}}};
    if (distance_between(mesh, ab, c) < distance_between(mesh, a, bc))
        return {3, {{{ab, b, bc}, {ab, bc, c}, {a, ab, c}}}};
    return {3, {{{ab, b, bc}, {a, ab, bc}, {a, bc, c}}}};
}

} // namespace

Mesh triangulated(Mesh mesh)
{
    if (mesh.corners.size() == 3 * mesh.face_count()) return mesh;
    const std::vector<glm::uvec3> all = triangles(mesh);
    const std::vector<std::uint32_t> begin = std::exchange(mesh.face_begin, {0});
    const std::vector<std::uint32_t> materials = std::exchange(mesh.face_material, {});
    const std::vector<std::uint32_t> groups = std::exchange(mesh.face_group, {});
    mesh.corners.clear();
    mesh.corners.reserve(3 * all.size());
    mesh.face_begin.reserve(all.size() + 1);
    for (std::size_t f = 0; f + 1 < begin.size(); ++f)
        for (std::size_t t = begin[f] - 2 * f; t < begin[f + 1] - 2 * (f + 1); ++t) {
            add_face(mesh, std::array{all[t].x, all[t].y, all[t].z});
            if (!materials.empty()) mesh.face_material.push_back(materials[f]);
            if (!groups.empty()) mesh.face_group.push_back(groups[f]);
        }
    return mesh;
}

std::vector<std::uint32_t> halve_edges(Mesh& mesh, std::size_t points, const EdgeNumbers& marked)
{
    assert(mesh.points.size() == mesh.vertex_count());
    std::vector<HalvedTriangle> halved = triangles_at(mesh, points, marked);
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertex_count());
    add_vertices(mesh, middles_of(halved, mesh, points, marked.count()));
    std::vector<std::uint32_t> changed;
    changed.reserve(4 * halved.size());
    for (const HalvedTriangle& each : halved) {
        const std::size_t f = each.face;
        const TriangleParts made = parts_of(each, mesh, first_vertex);
        for (std::size_t i = 0; i < 3; ++i)
            mesh.corners[3 * f + i] = made.parts[0][static_cast<int>(i)];
        changed.push_back(each.face);
        for (int k = 1; k < made.count; ++k) {
            const glm::uvec3& part = made.parts[static_cast<std::size_t>(k)];
            changed.push_back(static_cast<std::uint32_t>(mesh.face_count()));
            add_face(mesh, std::array{part.x, part.y, part.z});
            if (!mesh.face_material.empty()) mesh.face_material.push_back(mesh.face_material[f]);
            if (!mesh.face_group.empty()) mesh.face_group.push_back(mesh.face_group[f]);
        }
    }
    return changed;
}

} // namespace trivar
