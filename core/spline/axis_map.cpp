// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/axis_map.h"

namespace trivar {

AxisMap sampling_map(const Knots& knots, std::span<const double> parameters, int derivative)
{
    AxisMap map;
    map.width = knots.order();
    for (const double parameter : parameters) {
        const Knots::InDomain in = knots.into_domain(parameter);
        const Basis b = basis(knots, in.t, derivative);
        const auto& row = derivative == 0   ? b.value
                          : derivative == 1 ? b.first_derivative
                                            : b.second_derivative;
        map.first.push_back(b.first + (in.odd ? knots.count() : 0));
        map.weights.insert(map.weights.end(), row.begin(), row.begin() + knots.order());
    }
    return map;
}

} // namespace trivar
