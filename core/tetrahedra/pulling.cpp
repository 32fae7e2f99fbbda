// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/pulling.h"

#include "core/base/box.h"
#include "core/base/joined_sets.h"
#include "core/base/smooth_step.h"
#include "core/simplex/cell_faces.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace trivar {
namespace {

// The share of a rotation about X, then Y, then Z.
glm::dquat turn(const glm::dvec3& rotation_deg, double share)
{
    const glm::dvec3 a = glm::radians(rotation_deg);
    const glm::dquat whole = glm::angleAxis(a.z, glm::dvec3(0, 0, 1)) *
                             glm::angleAxis(a.y, glm::dvec3(0, 1, 0)) *
                             glm::angleAxis(a.x, glm::dvec3(1, 0, 0));
    return glm::slerp(glm::dquat(1, 0, 0, 0), whole, share);
}

// Returns how far a point is on the outside of the faces of a cell: below 0 in the cell, and at
// most its distance elsewhere.
double beyond(const std::array<glm::dvec3, 4>& c, const glm::dvec3& p)
{
    double out = -1e300;
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec3 &a = c[(k + 1) % 4], &b = c[(k + 2) % 4], &d = c[(k + 3) % 4];
        const glm::dvec3 n = glm::normalize(glm::cross(b - a, d - a));
        const double side = glm::dot(n, c[k] - a) > 0 ? -1 : 1;
        out = std::max(out, side * glm::dot(n, p - a));
    }
    return out;
}

// A bound of the distance of a point from a cell, from below.
double nearness(const std::array<glm::dvec3, 4>& corner, const glm::dvec3& p)
{
    Box box;
    for (const glm::dvec3& c : corner) box.add(c);
    return std::max(beyond(corner, p), glm::distance(p, glm::clamp(p, box.lo, box.hi)));
}

// The middle of where the middles of the balls are now: the control points that rest there, or the
// place itself.
glm::dvec3 middle_now(const TetrahedraPull& pull, const SimplexVolume& volume)
{
    const auto layer = static_cast<std::size_t>(pull.layer);
    const std::vector<glm::dvec3>& rest = volume.layers[layer]->rest();
    glm::dvec3 out(0);
    const std::vector<glm::dvec3> balls = middles(pull);
    for (const glm::dvec3& ball : balls) {
        const std::vector<bool> reach = reached(*volume.layers[layer], ball, pull.radius);
        std::size_t there = 0;
        while (there < rest.size() &&
               (!reach[there] || glm::distance(rest[there], ball) > 1e-3 * pull.radius))
            ++there;
        out +=
            there == rest.size() ? evaluate(volume, ball).position : place_of(volume, layer, there);
    }
    return out / static_cast<double>(balls.size());
}

} // namespace

std::vector<glm::dvec3> middles(const TetrahedraPull& pull)
{
    std::vector<glm::dvec3> out{pull.at};
    out.insert(out.end(), pull.also.begin(), pull.also.end());
    return out;
}

glm::dvec3 place_of(const SimplexVolume& volume, std::size_t layer, std::size_t point)
{
    const glm::dvec3& rest = volume.layers[layer]->rest()[point];
    return layer == 0 ? rest + volume.displacements[point] : evaluate(volume, rest).position;
}

double share_inside(const TetrahedraRefinement& refinement, const glm::dvec3& p)
{
    double nearest = 1e300;
    for (const glm::dvec3& place : refinement.places)
        nearest = std::min(nearest, glm::distance(place, p));
    // Functions at the rim lack neighbours that would balance their slopes, so theirs are not
    // moved.
    const double end = std::max(refinement.radius - refinement.edge, refinement.radius / 2);
    return smooth_step((1 - nearest / end) / 0.7);
}

std::vector<bool> reached(const SimplexBasis<3>& layer, const glm::dvec3& middle, double radius)
{
    const SimplexDomain<3>& domain = layer.domain();
    if (domain.cuts.empty()) return std::vector<bool>(layer.point_count(), true);
    std::vector<bool> touched(domain.cells.size());
    std::size_t holding = 0;
    std::pair<double, double> least{1e300, 1e300}; // of two cells that hold it the nearer one
    for (std::size_t c = 0; c < domain.cells.size(); ++c) {
        const auto corner = corners(domain, c);
        const double away = nearness(corner, middle);
        touched[c] = away <= radius;
        const std::pair<double, double> here{
            std::max(away, 0.0),
            glm::distance(middle, (corner[0] + corner[1] + corner[2] + corner[3]) / 4.0)};
        if (here >= least) continue;
        least = here;
        holding = c;
    }
    JoinedSets sets(domain.cells.size());
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f + 1 < faces.size(); ++f)
        if (faces[f].vertices == faces[f + 1].vertices && touched[faces[f].cell] &&
            touched[faces[f + 1].cell] &&
            !std::binary_search(domain.cuts.begin(), domain.cuts.end(), faces[f].vertices))
            sets.join(faces[f].cell, faces[f + 1].cell);
    std::vector<bool> out(layer.point_count(), false);
    const std::size_t per_cell = multi_indices<3>(domain.degree).size();
    const std::uint32_t here = sets.root(static_cast<std::uint32_t>(holding));
    for (std::size_t c = 0; c < domain.cells.size(); ++c)
        if (sets.root(static_cast<std::uint32_t>(c)) == here)
            for (std::size_t i = 0; i < per_cell; ++i)
                out[static_cast<std::size_t>(layer.point_of(c, i))] = true;
    return out;
}

std::vector<glm::dvec3> change_by(const TetrahedraPull& pull, const SimplexVolume& volume,
                                  const TetrahedraRefinement* refinement)
{
    std::vector<glm::dvec3> out(volume.displacements.size(), glm::dvec3(0));
    const auto layer = static_cast<std::size_t>(pull.layer);
    if (layer >= volume.layers.size() || !(pull.radius > 0)) return out;
    const std::size_t first = volume.first_point(layer);
    const SimplexBasis<3>& basis = *volume.layers[layer];
    std::vector<double> shares(basis.point_count(), 0);
    for (const glm::dvec3& ball : middles(pull)) {
        const std::vector<bool> reach = reached(basis, ball, pull.radius);
        for (std::size_t i = 0; i < shares.size(); ++i)
            if (reach[i])
                shares[i] =
                    std::max(shares[i],
                             decay(pull.decay, glm::distance(basis.rest()[i], ball) / pull.radius));
    }
    const bool turns = pull.rotation_deg != glm::dvec3(0) || pull.factors != glm::dvec3(1);
    const glm::dvec3 middle = turns ? middle_now(pull, volume) : glm::dvec3(0);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double share =
            shares[i] * (refinement ? share_inside(*refinement, basis.rest()[i]) : 1);
        if (share <= 0) continue;
        out[first + i] = pull.by * share;
        if (!turns) continue;
        const glm::dvec3 from = place_of(volume, layer, i) - middle;
        out[first + i] +=
            turn(pull.rotation_deg, share) * (glm::mix(glm::dvec3(1), pull.factors, share) * from) -
            from;
    }
    return out;
}

} // namespace trivar
