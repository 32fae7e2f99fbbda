// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/pulling.h"

#include "core/base/joined_sets.h"
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

double distance_to_cell(const SimplexDomain<3>& domain, std::size_t cell, const glm::dvec3& p)
{
    const auto corner = corners(domain, cell);
    glm::dvec3 lo = corner[0], hi = lo;
    for (const glm::dvec3& c : corner) {
        lo = glm::min(lo, c);
        hi = glm::max(hi, c);
    }
    return glm::distance(p, glm::clamp(p, lo, hi));
}

double inside(const TetrahedraRefinement& refinement, const glm::dvec3& p)
{
    double nearest = 1e300;
    for (const glm::dvec3& place : refinement.places)
        nearest = std::min(nearest, glm::distance(place, p));
    // Functions at the rim lack neighbours that would balance their slopes, so theirs are not
    // moved.
    const double end = std::max(refinement.radius - refinement.edge, refinement.radius / 2);
    const double t = glm::clamp((1 - nearest / end) / 0.7, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

std::vector<bool> reached(const SimplexBasis<3>& layer, const glm::dvec3& middle, double radius)
{
    const SimplexDomain<3>& domain = layer.domain();
    if (domain.cuts.empty()) return std::vector<bool>(layer.point_count(), true);
    std::vector<bool> touched(domain.cells.size());
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t c = 0; c < domain.cells.size(); ++c) {
        touched[c] = distance_to_cell(domain, c, middle) <= radius;
        const auto corner = corners(domain, c);
        const double away =
            glm::distance(middle, (corner[0] + corner[1] + corner[2] + corner[3]) / 4.0);
        if (away >= least) continue;
        least = away;
        nearest = c;
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
    const std::uint32_t here = sets.root(static_cast<std::uint32_t>(nearest));
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
    const std::vector<bool> reach = reached(basis, pull.at, pull.radius);
    const bool turns = pull.rotation_deg != glm::dvec3(0);
    for (std::size_t i = 0; i < basis.point_count(); ++i) {
        const glm::dvec3& rest = basis.rest()[i];
        const double share = decay(pull.decay, glm::distance(rest, pull.at) / pull.radius) *
                             (refinement ? inside(*refinement, rest) : 1);
        if (share <= 0 || !reach[i]) continue;
        out[first + i] = pull.by * share;
        if (!turns) continue;
        const glm::dvec3 from =
            layer == 0 ? rest + volume.displacements[i] : evaluate(volume, rest).position;
        out[first + i] += turn(pull.rotation_deg, share) * (from - pull.at) - (from - pull.at);
    }
    return out;
}

} // namespace trivar
