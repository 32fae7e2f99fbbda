// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/halve_edges.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/refinement/born_vertices.h"

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

    bool is_split(std::size_t i) const { return middles[i % 3] != EdgeNumbers::none; }
    std::size_t split_count() const
    {
        return std::size_t{is_split(0)} + std::size_t{is_split(1)} + std::size_t{is_split(2)};
    }
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
    // The first edge of vertices on each edge of points; the other edges are on seams.
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
    std::size_t count = 0;
    std::array<glm::uvec3, 4> parts;
};

double distance_between(const Mesh& mesh, std::uint32_t a, std::uint32_t b)
{
    return glm::distance(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]));
}

// The first of the parts takes the triangle's place.
TriangleParts parts_of(const HalvedTriangle& halved, const Mesh& mesh, std::uint32_t first_vertex)
{
    const std::size_t count = halved.split_count();
    std::size_t turn = 0; // so that the split edges are the first ones
    while (!halved.is_split(turn) || (count == 2 && !halved.is_split(turn + 1))) ++turn;
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
    const std::vector<std::uint32_t> begin = std::exchange(mesh.face_begin, {});
    const std::vector<std::uint32_t> materials = std::exchange(mesh.face_material, {});
    const std::vector<std::uint32_t> groups = std::exchange(mesh.face_group, {});
    mesh.corners.resize(3 * all.size());
    mesh.face_begin.resize(all.size() + 1);
    for (std::size_t t = 0; t < all.size(); ++t) {
        for (int i = 0; i < 3; ++i) mesh.corners[3 * t + static_cast<std::size_t>(i)] = all[t][i];
        mesh.face_begin[t + 1] = static_cast<std::uint32_t>(3 * (t + 1));
    }
    for (std::size_t f = 0; f + 1 < begin.size(); ++f) {
        const std::size_t count = begin[f + 1] - begin[f] - 2;
        if (!materials.empty())
            mesh.face_material.insert(mesh.face_material.end(), count, materials[f]);
        if (!groups.empty()) mesh.face_group.insert(mesh.face_group.end(), count, groups[f]);
    }
    return mesh;
}

std::vector<std::uint32_t> halve_edges(Mesh& mesh, std::size_t points, const EdgeNumbers& marked)
{
    ensure(mesh.points.size() == mesh.vertex_count(), "vertices have no points");
    std::vector<HalvedTriangle> halved = triangles_at(mesh, points, marked);
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertex_count());
    add_vertices(mesh, middles_of(halved, mesh, points, marked.count()));
    // Behind the others, those of each triangle that do not take its place
    std::vector<std::size_t> first_part(halved.size() + 1, mesh.face_count());
    for (std::size_t k = 0; k < halved.size(); ++k)
        first_part[k + 1] = first_part[k] + halved[k].split_count();
    const std::size_t faces = first_part.back();
    mesh.corners.resize(3 * faces);
    for (std::size_t f = mesh.face_count(); f < faces; ++f)
        mesh.face_begin.push_back(static_cast<std::uint32_t>(3 * (f + 1)));
    if (!mesh.face_material.empty()) mesh.face_material.resize(faces);
    if (!mesh.face_group.empty()) mesh.face_group.resize(faces);
    std::vector<std::uint32_t> changed(halved.size() + faces - first_part[0]);
    parallel_blocks(halved.size(), halved_per_turn, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint32_t face = halved[k].face;
            const TriangleParts made = parts_of(halved[k], mesh, first_vertex);
            std::uint32_t* next = changed.data() + k + (first_part[k] - first_part[0]);
            for (std::size_t i = 0; i < made.count; ++i) {
                const std::size_t f = i == 0 ? face : first_part[k] + i - 1;
                for (std::size_t c = 0; c < 3; ++c)
                    mesh.corners[3 * f + c] = made.parts[i][static_cast<int>(c)];
                if (!mesh.face_material.empty()) mesh.face_material[f] = mesh.face_material[face];
                if (!mesh.face_group.empty()) mesh.face_group[f] = mesh.face_group[face];
                *next++ = static_cast<std::uint32_t>(f);
            }
        }
    });
    return changed;
}

} // namespace trivar
