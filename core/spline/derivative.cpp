// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/derivative.h"

#include "core/base/index.h"

namespace trivar {
namespace {

// P_{i+1} - P_i, and the knot its control point brings into the derivative's sequence.
struct Difference {
    int i;
    double knot;
};

// Order 2: each span has its own constant, held by two equal points.
std::vector<Difference> constants(const Knots& knots)
{
    std::vector<Difference> out;
    const std::vector<double> breaks = knots.breaks();
    for (std::size_t b = 0; b + 1 < breaks.size(); ++b)
        out.insert(out.end(), 2, {knots.span(breaks[b]) - 1, breaks[b]});
    return out;
}

// Control point i of the derivative owns knot t[i + 1]; it is dropped with that knot where
// t[i + 1] .. t[i + o] are all one.
std::vector<Difference> differences(const Knots& knots, int first, int last)
{
    const auto& t = knots.values();
    std::vector<Difference> out;
    for (int i = first; i < last; ++i)
        if (t[at(i + 1)] < t[at(i + knots.order())]) out.push_back({i, t[at(i + 1)]});
    return out;
}

void add_row(AxisMap& map, const Knots& knots, int i, int turns)
{
    const auto& t = knots.values();
    const double slope = knots.degree() / (t[at(i + knots.order())] - t[at(i + 1)]);
    const int first = i + turns * knots.count();
    map.first.push_back(first < 0 ? first + 2 * knots.count() : first);
    map.weights.insert(map.weights.end(), {-slope, slope});
}

} // namespace

DerivativeNet derivative_net(const Knots& knots)
{
    const int o = knots.order(), order = std::max(2, o - 1), n = knots.count();
    AxisMap map;
    map.width = 2;
    std::vector<double> t;
    if (knots.closure() == Closure::open) {
        const auto all = o == 2 ? constants(knots) : differences(knots, 0, n - 1);
        for (const Difference& d : all) {
            add_row(map, knots, d.i, 0);
            t.push_back(d.knot);
        }
        if (o == 2) t.insert(t.end(), 2, knots.end());
        for (int i = n; o > 2 && i < n + o - 1; ++i) t.push_back(knots.values()[at(i)]);
        return {Knots::general(order, std::move(t)), map};
    }
    // One period from the begin of the domain on. Stored points start order - 1 knots before it,
    // in the period before.
    const auto all = o == 2 ? constants(knots) : differences(knots, o - 2, o - 2 + n);
    const int count = static_cast<int>(all.size());
    for (const Difference& d : all) t.push_back(d.knot);
    for (int j = 1 - order; j < count + 1 - order; ++j)
        add_row(map, knots, all[at(j < 0 ? j + count : j)].i, j < 0 ? -1 : 0);
    return {Knots::closed(order, t, knots.end(), knots.closure()), map};
}

} // namespace trivar
