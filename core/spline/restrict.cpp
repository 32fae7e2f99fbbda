// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/restrict.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

namespace trivar {

Knots restricted(const Knots& knots, double lo, double hi)
{
    if (!(knots.begin() <= lo && lo < hi && hi <= knots.end()))
        throw Rejected("the part from " + shortest(lo) + " to " + shortest(hi) +
                       " does not lie inside the axis, which runs from " + shortest(knots.begin()) +
                       " to " + shortest(knots.end()));
    const auto order = static_cast<std::size_t>(knots.order());
    std::vector<double> t(order, lo);
    for (const double knot : knots.values())
        if (knot > lo && knot < hi) t.push_back(knot);
    t.insert(t.end(), order, hi);
    return Knots::general(knots.order(), std::move(t));
}

} // namespace trivar
