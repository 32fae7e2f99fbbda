// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/insert.h"

#include "core/base/index.h"
#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>

namespace trivar {
namespace {

// Returns the first span of the domain, from j on, that has a length; the last such span if there
// is none.
int piece_of(const Knots& knots, int j)
{
    const auto& t = knots.values();
    int s = std::max(j, knots.degree());
    while (s < knots.unwrapped_count() && t[at(s)] == t[at(s + 1)]) ++s;
    return s < knots.unwrapped_count() ? s : knots.span(knots.end());
}

} // namespace

// Computes the blossom: the recursion of the basis functions with a different argument in each
// step.
std::array<double, max_order> blossom(const std::vector<double>& t, int s, int degree,
                                      const double* arguments)
{
    std::array<double, max_order> n{1};
    for (int p = 1; p <= degree; ++p) {
        const double u = arguments[p - 1];
        double saved = 0;
        for (int r = 0; r < p; ++r) {
            const double right = t[at(s + r + 1)], left = t[at(s + 1 - p + r)];
            const double share = n[at(r)] / (right - left);
            n[at(r)] = saved + (right - u) * share;
            saved = (u - left) * share;
        }
        n[at(p)] = saved;
    }
    return n;
}

AxisMap refinement_map(const Knots& from, const Knots& to)
{
    ensure(from.order() == to.order(), "knots are of two orders");
    ensure(to.begin() >= from.begin() && to.end() <= from.end(), "knots reach beyond a domain");
    const int d = from.degree();
    AxisMap map;
    map.width = from.order();
    for (int j = 0; j < to.count(); ++j) {
        const int s = from.span(to.values()[at(piece_of(to, j))]);
        const auto row = blossom(from.values(), s, d, to.values().data() + j + 1);
        map.first.push_back(s - d);
        map.weights.insert(map.weights.end(), row.begin(), row.begin() + from.order());
    }
    return map;
}

Knots with_inserted(const Knots& knots, std::span<const double> inserted)
{
    for (const double t : inserted)
        if (!(t >= knots.begin() && t <= knots.end()))
            throw Rejected("a knot at " + shortest(t) + " lies outside the axis, which runs from " +
                           shortest(knots.begin()) + " to " + shortest(knots.end()));
    if (knots.closure() == Closure::open) {
        std::vector<double> all = knots.values();
        all.insert(all.end(), inserted.begin(), inserted.end());
        std::sort(all.begin(), all.end());
        return Knots::general(knots.order(), std::move(all));
    }
    const auto first = knots.values().begin() + knots.degree();
    std::vector<double> period(first, first + knots.count());
    for (const double t : inserted) period.push_back(t == knots.end() ? knots.begin() : t);
    std::sort(period.begin(), period.end());
    return Knots::closed(knots.order(), period, knots.end(), knots.closure());
}

Knots opened(const Knots& knots)
{
    std::vector<double> all(at(knots.order()), knots.begin());
    for (const double t : knots.values())
        if (t > knots.begin() && t < knots.end()) all.push_back(t);
    all.insert(all.end(), at(knots.order()), knots.end());
    return Knots::general(knots.order(), std::move(all));
}

} // namespace trivar
