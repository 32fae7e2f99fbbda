// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incised.h"

#include <algorithm>
#include <cassert>

namespace trivar {

OpenedVertices opened_vertices(const IncisedMesh& incised,
                               std::span<const IncisionOpening> openings,
                               std::vector<glm::dvec3> more)
{
    assert(openings.size() == incised.outcomes.size());
    assert(more.empty() || more.size() == incised.slots);
    const Mesh& rest = *incised.rest;
    std::vector<glm::dvec3> moves = std::move(more);
    moves.resize(incised.slots, glm::dvec3(0));
    for (const IncisedMesh::Term& term : incised.terms) {
        const IncisionOpening& opening = openings[term.incision];
        const bool whole = opening.from <= 0 && opening.to >= 1;
        const double share = whole ? opening.share : share_at(opening, term.share);
        moves[term.slot] += share * glm::dvec3(term.move);
    }
    OpenedVertices out;
    out.positions.reserve(incised.moved.size());
    for (std::size_t i = 0; i < incised.moved.size(); ++i)
        out.positions.emplace_back(glm::dvec3(rest.positions[incised.moved[i]]) +
                                   moves[incised.slot_of_moved[i]]);
    if (rest.normals.empty()) return out;

    const std::uint32_t first = incised.first_wall_vertex;
    std::vector<glm::dvec3> walls(rest.positions.begin() + first, rest.positions.end());
    for (std::size_t i = 0; i < incised.moved.size(); ++i)
        if (incised.moved[i] >= first) walls[incised.moved[i] - first] = out.positions[i];
    std::vector<glm::dvec3> sums(walls.size(), glm::dvec3(0));
    for (std::size_t f = incised.first_wall_face; f < rest.face_count(); ++f) {
        const std::uint32_t* const c = rest.corners.data() + rest.face_begin[f];
        const glm::dvec3 a = walls[c[0] - first], b = walls[c[1] - first], d = walls[c[2] - first];
        for (int i = 0; i < 3; ++i) sums[c[i] - first] += glm::cross(b - a, d - a);
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const double length = glm::length(sums[v]);
        out.wall_normals.push_back(length > 0 ? glm::vec3(sums[v] / length)
                                              : rest.normals[first + v]);
    }
    return out;
}

bool is_open(const IncisedMesh& incised, std::span<const IncisionOpening> openings)
{
    if (incised.rest == incised.original) return false;
    if (incised.has_hole) return true;
    for (std::size_t k = 0; k < openings.size(); ++k)
        if (openings[k].share * incised.outcomes[k].widest != 0) return true;
    return false;
}

void put(const IncisedMesh& incised, const OpenedVertices& vertices, Mesh& copy)
{
    for (std::size_t i = 0; i < incised.moved.size(); ++i)
        copy.positions[incised.moved[i]] = vertices.positions[i];
    std::ranges::copy(vertices.wall_normals, copy.normals.begin() + incised.first_wall_vertex);
}

Ref<Mesh> opened(const IncisedMesh& incised, std::span<const IncisionOpening> openings)
{
    if (!is_open(incised, openings)) return incised.original;
    Mesh mesh = *incised.rest;
    put(incised, opened_vertices(incised, openings), mesh);
    return make_ref(std::move(mesh));
}

} // namespace trivar
