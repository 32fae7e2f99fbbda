// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_ray.h"

#include "core/rays/nearest_face.h"

#include <algorithm>

namespace trivar {
namespace {

bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& along, double nearer_than)
{
    double from = 0, to = nearer_than;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.lo[axis] - origin[axis]) / along[axis],
                     b = (box.hi[axis] - origin[axis]) / along[axis];
        from = std::max(from, std::min(a, b)); // not a number, in a side's plane: no bound
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

} // namespace

std::optional<TileHit> first_tile(const TileSet& set, const glm::dvec3& origin,
                                  const glm::dvec3& along, double nearer_than)
{
    std::optional<TileHit> out;
    for (std::size_t r = 0; r < set.hulls.size(); ++r) {
        if (!meets(set.hulls[r], origin, along, nearer_than)) continue;
        const std::vector<TileSet::Extent>& extents = *set.extents.runs()[r];
        for (std::size_t i = 0; i < extents.size(); ++i) {
            if (!meets(extents[i].hull, origin, along, nearer_than)) continue;
            const Mesh bent = bent_tiles(*set.model->mesh, {set.tiles->runs()[r]->data() + i, 1});
            const double t = nearest_face(bent, glm::dmat4(1), origin, along, nearer_than);
            if (!(t < nearer_than)) continue;
            nearer_than = t;
            out = TileHit{set.extents.begin_of(r) + i, t};
        }
    }
    return out;
}

} // namespace trivar
