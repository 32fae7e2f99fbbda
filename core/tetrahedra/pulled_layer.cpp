// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/pulled_layer.h"

#include <algorithm>

namespace trivar {

int pulled_layer(const TetrahedraShape& shape, const glm::dvec3& middle, double radius)
{
    const auto has_within = [&](const std::vector<glm::dvec3>& places, double reach) {
        return std::ranges::any_of(
            places, [&](const glm::dvec3& place) { return glm::distance(place, middle) <= reach; });
    };
    int out = 0, layer = 0;
    for (const TetrahedraEdit& edit : shape.edits) {
        if (edit.crease && edit.crease->depth >= shape.degree && !edit.crease->seam &&
            has_within(edit.crease->places, edit.crease->radius + radius))
            return 0;
        if (!edit.refinement) continue;
        ++layer;
        if (has_within(edit.refinement->places, edit.refinement->radius)) out = layer;
    }
    return out;
}

} // namespace trivar
