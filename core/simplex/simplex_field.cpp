// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_field.h"

namespace trivar {

FieldPoint evaluate(const SimplexField& field, const glm::dvec3& x, bool gradient)
{
    std::vector<BasisValue<3>> values;
    field.basis->values_at(x, gradient, values);
    FieldPoint out;
    for (const BasisValue<3>& each : values) {
        const double c = field.values[static_cast<std::size_t>(each.point)];
        out.value += c * each.value;
        out.gradient += c * each.gradient;
    }
    return out;
}

} // namespace trivar
