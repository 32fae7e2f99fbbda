// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/knots.h"

#include "core/base/index.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace trivar {
namespace {

using Row = std::array<double, max_order>;

// Computes all basis functions of order o that are not zero on span s.
Row values_of_order(const std::vector<double>& t, int s, int o, double u)
{
    Row n{1};
    Row left{}, right{};
    for (int p = 1; p < o; ++p) {
        left[at(p)] = u - t[at(s + 1 - p)];
        right[at(p)] = t[at(s + p)] - u;
        double saved = 0;
        for (int r = 0; r < p; ++r) {
            const double share = n[at(r)] / (right[at(r + 1)] + left[at(p - r)]);
            n[at(r)] = saved + right[at(r + 1)] * share;
            saved = left[at(p - r)] * share;
        }
        n[at(p)] = saved;
    }
    return n;
}

// Computes the derivatives N_i' = d (N_i^{d-1} / (t_{i+d} - t_i) - N_{i+1}^{d-1} / (t_{i+d+1} -
// t_{i+1})), where a term with a zero denominator is 0.
Row differentiated(const std::vector<double>& t, int s, int o, const Row& lower)
{
    Row out{};
    const int d = o - 1;
    for (int r = 0; r < o; ++r) {
        const int i = s - d + r;
        double slope = 0;
        if (r > 0 && t[at(i + d)] > t[at(i)]) slope += lower[at(r - 1)] / (t[at(i + d)] - t[at(i)]);
        if (r < d && t[at(i + d + 1)] > t[at(i + 1)])
            slope -= lower[at(r)] / (t[at(i + d + 1)] - t[at(i + 1)]);
        out[at(r)] = d * slope;
    }
    return out;
}

void check_size(int order, int count)
{
    if (order < 2 || order > max_order)
        throw Rejected("order " + std::to_string(order) + " is outside 2 to 6");
    if (count < order)
        throw Rejected("order " + std::to_string(order) + " needs at least " +
                       std::to_string(order) + " control points, there are " +
                       std::to_string(count));
    constexpr int most = 1 << 20; // more than any useful axis
    if (count > most)
        throw Rejected(std::to_string(count) + " control points on an axis are more than " +
                       std::to_string(most));
}

} // namespace

Knots::Knots(int order, int count, Closure closure, std::vector<double> knots)
    : order_(order),
      count_(count),
      closure_(closure),
      knots_(std::move(knots))
{
    check_size(order, count);
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (!std::isfinite(knots_[i]))
            throw Rejected("knot " + std::to_string(i) + " is not a number");
        if (i > 0 && knots_[i] < knots_[i - 1])
            throw Rejected("knot " + std::to_string(i) + " is smaller than the one before it");
        if (i >= at(order) && knots_[i] == knots_[i - at(order)])
            throw Rejected("knot " + std::to_string(i) + " repeats more than the order allows");
    }
    if (!(end() > begin())) throw Rejected("the knots enclose no interval");
}

Knots Knots::uniform(int order, int count, double begin, double end)
{
    check_size(order, count);
    std::vector<double> t;
    const int spans = count - order + 1;
    for (int i = 0; i < count + order; ++i) {
        const int step = std::clamp(i - order + 1, 0, spans);
        t.push_back(step == spans ? end : begin + (end - begin) * step / spans);
    }
    return {order, count, Closure::open, std::move(t)};
}

Knots Knots::general(int order, std::vector<double> knots)
{
    // The size is limited so that the conversion cannot overflow; the constructor reports the
    // error.
    const auto size = static_cast<int>(std::min(knots.size(), std::size_t{1} << 22));
    const int count = size - std::clamp(order, 0, 16);
    return {order, count, Closure::open, std::move(knots)};
}

Knots Knots::periodic(int order, int count, double begin, double end, Closure closure)
{
    check_size(order, count);
    std::vector<double> one_period;
    one_period.reserve(at(count));
    for (int i = 0; i < count; ++i) one_period.push_back(begin + (end - begin) * i / count);
    return closed(order, one_period, end, closure);
}

Knots Knots::closed(int order, const std::vector<double>& one_period, double end, Closure closure)
{
    const int count = static_cast<int>(one_period.size());
    check_size(order, count);
    const double period = end - one_period.front();
    if (!(one_period.back() < end)) throw Rejected("a knot lies beyond the end of the period");
    // The knots are order - 1 of the period before, one period, and order of the period after.
    std::vector<double> t;
    for (int i = 1 - order; i < count + order; ++i) {
        const int turn = i < 0 ? -1 : i / count;
        const double knot = one_period[at(i - turn * count)];
        t.push_back(i == count ? end : knot + turn * period);
    }
    return {order, count, closure, std::move(t)};
}

Knots::InDomain Knots::into_domain(double t) const
{
    if (closure_ == Closure::open) return {std::clamp(t, begin(), end()), false};
    const double period = end() - begin();
    const double turns = std::floor((t - begin()) / period);
    const double inside = std::clamp(t - turns * period, begin(), end());
    return {inside, closure_ == Closure::twisted && std::fmod(turns, 2) != 0};
}

int Knots::span(double t) const
{
    const auto first = knots_.begin() + order_ - 1;
    const auto last = knots_.begin() + unwrapped_count();
    auto above = std::upper_bound(first, last + 1, t);
    // At the end of the domain this is the last span that has a length.
    if (above == last + 1) above = std::lower_bound(first, last + 1, *last);
    return static_cast<int>(above - knots_.begin()) - 1;
}

double Knots::greville(int i) const
{
    double sum = 0;
    for (int k = 1; k < order_; ++k) sum += knots_[at(i + k)];
    return sum / (order_ - 1);
}

int Knots::multiplicity(double t) const
{
    const auto [first, last] = std::equal_range(knots_.begin(), knots_.end(), t);
    return static_cast<int>(last - first);
}

std::vector<double> Knots::breaks() const
{
    std::vector<double> out(knots_.begin() + order_ - 1, knots_.begin() + unwrapped_count() + 1);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

Basis basis(const Knots& knots, double t, int derivatives)
{
    const auto& values = knots.values();
    const int o = knots.order();
    const int s = knots.span(t);
    Basis out;
    out.first = s - o + 1;
    out.value = values_of_order(values, s, o, t);
    if (derivatives > 0) {
        const Row lower = values_of_order(values, s, o - 1, t);
        out.first_derivative = differentiated(values, s, o, lower);
    }
    if (derivatives > 1 && o > 2) {
        const Row lowest = values_of_order(values, s, o - 2, t);
        const Row lower = differentiated(values, s, o - 1, lowest);
        out.second_derivative = differentiated(values, s, o, lower);
    }
    return out;
}

} // namespace trivar
