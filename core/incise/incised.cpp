// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incised.h"

#include "core/base/mistake.h"

#include <algorithm>

namespace trivar {

namespace {

constexpr double quite_held = 0.1; // opening from which on an incision holds others as it can

} // namespace

double held_open(const IncisedMesh& incised, std::uint32_t incision,
                 std::span<const IncisionOpening> openings)
{
    double most = 0;
    for (const std::uint32_t by : incised.outcomes[incision].held_by)
        if (openings[by].to > openings[by].from) most = std::max(most, openings[by].share);
    return std::min(1.0, most / quite_held);
}

OpenedVertices opened_vertices(const IncisedMesh& incised,
                               std::span<const IncisionOpening> openings,
                               std::vector<glm::dvec3> more)
{
    ensure(openings.size() == incised.outcomes.size(), "an incision has no opening");
    ensure(more.empty() || more.size() == incised.slots, "moves are not of this mesh");
    const Mesh& rest = *incised.rest;
    std::vector<glm::dvec3> moves = std::move(more);
    moves.resize(incised.slots, glm::dvec3(0));
    std::vector<double> held; // how far those are open that hold each, up to 1
    for (std::uint32_t k = 0; k < openings.size(); ++k)
        held.push_back(held_open(incised, k, openings));
    for (const IncisedMesh::Term& term : incised.terms) {
        const IncisionOpening& opening = openings[term.incision];
        const bool whole = opening.from <= 0 && opening.to >= 1;
        const double share = whole ? opening.share : share_at(opening, term.share);
        const double left = 1 - held[term.incision] * (1 - double{term.held});
        moves[term.slot] += share * left * glm::dvec3(term.move);
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
        if (openings[k].share * incised.outcomes[k].widest_alone != 0) return true;
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
