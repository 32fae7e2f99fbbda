// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/halve_edges.h"

#include "core/refinement/born_vertices.h"

#include <algorithm>

namespace trivar {
namespace {

using Middles = std::array<std::uint32_t, 3>; // by edge of a triangle; none: it is not split

double distance_between(const Mesh& mesh, std::uint32_t a, std::uint32_t b)
{
    return glm::distance(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]));
}

// The triangles that one becomes, the first of which takes its place.
std::vector<glm::uvec3> pieces_of(const Mesh& mesh, const glm::uvec3& corners,
                                  const Middles& middles)
{
    const auto is_split = [&](std::size_t i) { return middles[i % 3] != EdgeNumbers::none; };
    const int count = is_split(0) + is_split(1) + is_split(2);
    std::size_t turn = 0; // so that the split edges are the first ones
    while (!is_split(turn) || (count == 2 && !is_split(turn + 1))) ++turn;
    const auto corner = [&](std::size_t i) { return corners[static_cast<int>((turn + i) % 3)]; };
    const std::uint32_t a = corner(0), b = corner(1), c = corner(2);
    const std::uint32_t ab = middles[turn % 3], bc = middles[(turn + 1) % 3],
                        ca = middles[(turn + 2) % 3];
    if (count == 1) return {{a, ab, c}, {ab, b, c}};
    if (count == 3) return {{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}};
    if (distance_between(mesh, ab, c) < distance_between(mesh, a, bc))
        return {{ab, b, bc}, {ab, bc, c}, {a, ab, c}};
    return {{ab, b, bc}, {a, ab, bc}, {a, bc, c}};
}

} // namespace

Mesh triangulated(const Mesh& mesh)
{
    if (mesh.corners.size() == 3 * mesh.face_count()) return mesh;
    Mesh out = mesh;
    const std::vector<glm::uvec3> all = triangles(mesh);
    out.corners.clear();
    out.face_begin = {0};
    out.face_material.clear();
    out.face_group.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t t = mesh.face_begin[f] - 2 * f; t < mesh.face_begin[f + 1] - 2 * (f + 1);
             ++t) {
            add_face(out, std::array{all[t].x, all[t].y, all[t].z});
            if (!mesh.face_material.empty()) out.face_material.push_back(mesh.face_material[f]);
            if (!mesh.face_group.empty()) out.face_group.push_back(mesh.face_group[f]);
        }
    return out;
}

std::vector<std::uint32_t> halve_edges(Mesh& mesh, const EdgeNumbers& marked)
{
    struct Split {
        std::uint32_t face;
        Middles middles;
    };
    std::vector<Split> splits;
    EdgeNumbers edges(marked.count()); // by vertices
    std::vector<BornVertex> born;
    const auto first_point = static_cast<std::uint32_t>(point_count(mesh));
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertex_count());
    const std::size_t faces = mesh.face_count();
    for (std::size_t f = 0; f < faces; ++f) {
        Split each{static_cast<std::uint32_t>(f), {}};
        bool any = false;
        for (std::size_t i = 0; i < 3; ++i) {
            std::uint32_t a = mesh.corners[3 * f + i], b = mesh.corners[3 * f + (i + 1) % 3];
            const std::uint32_t number = marked.number(mesh.point(a), mesh.point(b));
            each.middles[i] = EdgeNumbers::none;
            if (number == EdgeNumbers::none) continue;
            any = true;
            const std::uint32_t edge = edges.add(a, b);
            each.middles[i] = first_vertex + edge;
            if (edge < born.size()) continue;
            if (mesh.point(b) < mesh.point(a)) std::swap(a, b);
            born.push_back({a, b, 0.5f, first_point + number});
        }
        if (any) splits.push_back(each);
    }
    add_vertices(mesh, born);
    std::vector<std::uint32_t> changed;
    for (const Split& each : splits) {
        const std::uint32_t* const c = mesh.corners.data() + 3 * std::size_t{each.face};
        const std::vector<glm::uvec3> pieces = pieces_of(mesh, {c[0], c[1], c[2]}, each.middles);
        for (int i = 0; i < 3; ++i)
            mesh.corners[3 * std::size_t{each.face} + static_cast<std::size_t>(i)] = pieces[0][i];
        changed.push_back(each.face);
        for (std::size_t k = 1; k < pieces.size(); ++k) {
            changed.push_back(static_cast<std::uint32_t>(mesh.face_count()));
            add_face(mesh, std::array{pieces[k].x, pieces[k].y, pieces[k].z});
            if (!mesh.face_material.empty())
                mesh.face_material.push_back(mesh.face_material[each.face]);
            if (!mesh.face_group.empty()) mesh.face_group.push_back(mesh.face_group[each.face]);
        }
    }
    return changed;
}

} // namespace trivar
