// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/ffd/embedding.h"
#include "core/ffd/lattice.h"

#include <vector>

namespace trivar {

// A NextVolume is a further volume of a chain; its embedding maps the output of the volume before.
struct NextVolume {
    Embedding embedding;
    Ref<Lattice> lattice;
    bool operator==(const NextVolume&) const = default;
};

// The place of a point after one volume, and after all of several, one after the other.
inline glm::dvec3 through(const NextVolume& next, const glm::dvec3& p_world)
{
    const glm::dvec4 p(p_world, 1);
    const glm::dvec3 uvw(next.embedding.to_uvw * p);
    return evaluate(next.lattice->displacement, uvw).value + glm::dvec3(next.embedding.to_rest * p);
}
inline glm::dvec3 through(const std::vector<NextVolume>& volumes, glm::dvec3 p_world)
{
    for (const NextVolume& next : volumes) p_world = through(next, p_world);
    return p_world;
}

} // namespace trivar
