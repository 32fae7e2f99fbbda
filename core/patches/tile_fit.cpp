// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_fit.h"

#include "core/base/box.h"
#include "core/base/finite.h"

#include <algorithm>

namespace trivar {
namespace {

// Returns the rotation nearest to a matrix whose determinant is above 0, by Newton's iteration
// X <- (X + X^-T) / 2 (Higham 1986).
glm::dmat3 nearest_rotation(glm::dmat3 m)
{
    constexpr int most_steps = 40;
    for (int step = 0; step < most_steps; ++step) {
        const glm::dmat3 other = glm::transpose(glm::inverse(m)), next = 0.5 * (m + other);
        double change = 0;
        for (int c = 0; c < 3; ++c) change = std::max(change, glm::distance(next[c], m[c]));
        m = next;
        if (change < 1e-15) break;
    }
    return m;
}

// Adds the translation after which the box of the remaining distances has its middle at 0.
glm::dmat4 centred(const Mesh& unit, const BentPlaces& to, const glm::dmat3& turn)
{
    Box left;
    for (std::size_t v = 0; v < to.places.size(); ++v)
        left.add(to.places[v] - turn * glm::dvec3(unit.positions[v]));
    glm::dmat4 out(turn);
    out[3] = glm::dvec4(left.empty() ? to.middle : left.center(), 1);
    return out;
}

glm::dmat3 scaled_columns(const glm::dmat3& m, const glm::dvec3& scale)
{
    return {m[0] * scale.x, m[1] * scale.y, m[2] * scale.z};
}

} // namespace

BentPlaces bent_places(const Mesh& unit, const PlacedTile& tile, const glm::dmat4& to_world)
{
    BentPlaces out;
    out.places.reserve(unit.vertex_count());
    const auto unit_at = [&](std::size_t v) { return glm::dvec3(unit.positions[v]); };
    for (std::size_t v = 0; v < unit.vertex_count(); ++v) {
        const glm::dvec3 u = unit_at(v);
        const TilePoint bent = tile_point(tile.patch, {u.x, u.y, tile.height * u.z + tile.base});
        out.places.emplace_back(to_world * glm::dvec4(bent.p, 1));
        out.unit_middle += u;
        out.middle += out.places.back();
    }
    const double share = 1 / std::max(1.0, static_cast<double>(unit.vertex_count()));
    out.unit_middle *= share;
    out.middle *= share;
    for (std::size_t v = 0; v < unit.vertex_count(); ++v) {
        const glm::dvec3 u = unit_at(v) - out.unit_middle, p = out.places[v] - out.middle;
        out.unit_spread += share * glm::outerProduct(u, u);
        out.spread += share * glm::outerProduct(p, u);
    }
    const TilePoint frame =
        tile_point(tile.patch, {0.5, 0.5, tile.height * out.unit_middle.z + tile.base});
    constexpr double little = 1e-6;
    out.unit_spread += glm::dmat3(little);
    out.spread +=
        little * (glm::dmat3(to_world) * glm::dmat3(frame.x, frame.y, tile.height * frame.z));
    return out;
}

glm::dmat4 fitted_matrix(const Mesh& unit, const BentPlaces& to)
{
    return centred(unit, to, to.spread * glm::inverse(to.unit_spread));
}

std::optional<NodeTransform> fitted_parts(const Mesh& unit, const BentPlaces& to)
{
    const glm::dmat3 free = to.spread * glm::inverse(to.unit_spread);
    glm::dvec3 scale(glm::length(free[0]), glm::length(free[1]), glm::length(free[2]));
    glm::dmat3 turn(1);
    constexpr int turns = 12;
    for (int i = 0; i < turns; ++i) {
        glm::dmat3 m = scaled_columns(to.spread, scale);
        const double size = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
        if (!(size > 0)) return {};
        m /= size;
        if (!(glm::determinant(m) > 1e-24)) return {};
        turn = nearest_rotation(m);
        for (int k = 0; k < 3; ++k) {
            scale[k] = glm::dot(turn[k], to.spread[k]) / to.unit_spread[k][k];
            if (!(scale[k] > 0)) return {};
        }
    }
    if (!finite(turn[0]) || !finite(turn[1]) || !finite(turn[2])) return {};
    NodeTransform out;
    out.rotation = glm::normalize(glm::quat_cast(turn));
    out.scale = scale;
    out.translation = glm::dvec3(centred(unit, to, scaled_columns(turn, scale))[3]);
    return out;
}

double furthest(const Mesh& unit, const BentPlaces& from, const glm::dmat4& matrix)
{
    double most = 0;
    for (std::size_t v = 0; v < from.places.size(); ++v) {
        const glm::dvec3 there(matrix * glm::dvec4(glm::dvec3(unit.positions[v]), 1));
        const double off = glm::distance(there, from.places[v]);
        if (!(off <= most)) most = std::isfinite(off) ? off : infinite;
    }
    return most;
}

} // namespace trivar
