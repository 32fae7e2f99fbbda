// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_volume.h"

#include <cmath>

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

std::optional<glm::dvec3> inverse(const SimplexVolume& volume, const glm::dvec3& p,
                                  double tolerance)
{
    glm::dvec3 x = p;
    SimplexPoint at = evaluate(volume, x, true);
    double away = glm::distance(at.position, p);
    for (int step = 0; step < 50 && away > tolerance; ++step) {
        if (std::abs(glm::determinant(at.jacobian)) < 1e-9) return {};
        const glm::dvec3 way = glm::inverse(at.jacobian) * (p - at.position);
        bool nearer = false;
        for (double share = 1; share > 1e-3 && !nearer; share /= 2) {
            const SimplexPoint next = evaluate(volume, x + way * share, true);
            const double then = glm::distance(next.position, p);
            if (then >= away) continue;
            nearer = true;
            x += way * share;
            at = next;
            away = then;
        }
        if (!nearer) return {};
    }
    return away <= tolerance ? std::optional(x) : std::nullopt;
}

} // namespace trivar
