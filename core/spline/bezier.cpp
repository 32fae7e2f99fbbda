// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/bezier.h"

#include <algorithm>

namespace trivar {

Knots bezier_knots(const Knots& knots)
{
    const Knots open = opened(knots);
    std::vector<double> t;
    for (const double b : open.breaks()) {
        const int repeats = std::max(open.multiplicity(b), open.degree());
        t.insert(t.end(), static_cast<std::size_t>(repeats), b);
    }
    return Knots::general(knots.order(), std::move(t));
}

std::vector<BezierSpan> bezier_spans(const Knots& bezier)
{
    const std::vector<double> breaks = bezier.breaks();
    std::vector<BezierSpan> out;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        out.push_back({breaks[i], breaks[i + 1], bezier.span(breaks[i]) - bezier.degree()});
    return out;
}

std::array<double, max_order * max_order> bezier_segment(int order, double lo, double hi)
{
    // This is de Casteljau's triangle with a different argument in each step.
    std::array<double, max_order * max_order> out{};
    const int d = order - 1;
    for (int i = 0; i < order; ++i) {
        std::array<double, max_order> n{1};
        for (int p = 1; p <= d; ++p) {
            const double u = p <= d - i ? lo : hi;
            for (int r = p; r >= 0; --r) {
                const auto R = static_cast<std::size_t>(r);
                n[R] = (r < p ? n[R] * (1 - u) : 0) + (r > 0 ? n[R - 1] * u : 0);
            }
        }
        std::copy_n(n.begin(), order, out.begin() + i * order);
    }
    return out;
}

} // namespace trivar
