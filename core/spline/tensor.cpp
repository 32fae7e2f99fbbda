// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/tensor.h"

#include "core/base/rejected.h"

#include <cmath>
#include <string>

namespace trivar {
namespace {

bool can_be_mirrored(const Knots& knots)
{
    if (knots.closure() != Closure::open) return false;
    const auto& t = knots.values();
    const double sum = knots.begin() + knots.end();
    // Symmetry is tested up to the rounding of equally spaced knots.
    const double rounding = 1e-12 * std::max(std::abs(knots.begin()), std::abs(knots.end()));
    for (std::size_t i = 0; i < t.size(); ++i)
        if (!(std::abs(t[i] + t[t.size() - 1 - i] - sum) <= rounding)) return false;
    return true;
}

} // namespace

void check_shape(std::span<const Knots> axes, std::size_t points)
{
    std::size_t wanted = 1;
    for (const Knots& k : axes) {
        wanted *= static_cast<std::size_t>(k.count());
        if (wanted > points) break; // stops before the product can overflow
    }
    if (points != wanted)
        throw Rejected("there are " + std::to_string(points) +
                       " control points, which does not fit the axes of the spline");
    for (std::size_t twisted = 0; twisted < axes.size(); ++twisted) {
        if (axes[twisted].closure() != Closure::twisted) continue;
        for (std::size_t other = 0; other < axes.size(); ++other)
            if (other != twisted && !can_be_mirrored(axes[other]))
                throw Rejected("a twisted axis needs the other axes open and their knots "
                               "symmetric, because it mirrors them");
    }
}

} // namespace trivar
