// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_volume.h"

namespace trivar {

std::size_t SimplexVolume::first_point(std::size_t layer) const
{
    std::size_t out = 0;
    for (std::size_t l = 0; l < layer; ++l) out += layers[l]->point_count();
    return out;
}

SimplexPoint evaluate(const SimplexVolume& volume, const glm::dvec3& x, bool derivative)
{
    SimplexPoint out{x};
    std::vector<BasisValue<3>> values;
    for (std::size_t l = 0; l < volume.layers.size(); ++l) {
        const std::size_t first = volume.first_point(l);
        volume.layers[l]->values_at(x, derivative, values);
        for (const BasisValue<3>& each : values) {
            const glm::dvec3& d =
                volume.displacements[first + static_cast<std::size_t>(each.point)];
            out.position += d * each.value;
            out.jacobian += glm::outerProduct(d, each.gradient);
        }
    }
    return out;
}

} // namespace trivar
