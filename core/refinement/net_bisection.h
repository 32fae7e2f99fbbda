// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/simplex_net.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {

// Gives the nets on both halves of an edge, or of a triangle (a, b, c) that is cut through the
// middle m of a and b. The halves are (c, a, m) and (b, c, m), so that another edge is cut next
// time. Only means of points are taken, as de Casteljau does. `degree` is a number, or a constant
// that the compiler knows.
template <int corners, class Net> void bisect(const Net& net, auto degree, Net& p, Net& q)
{
    const int most = degree;
    std::array<glm::dvec4, std::tuple_size_v<Net>> row;
    for (int k = 0; k <= (corners == 2 ? 0 : most); ++k) {
        const int n = most - k;
        const auto index = [](int j, int i) { return at(net_index<corners>(j + i, i)); };
        for (int j = 0; j <= n; ++j) row[at(j)] = net[index(j, k)];
        for (int s = 0; s <= n; ++s) {
            p[corners == 2 ? at(s) : index(n - s, s)] = row[0];
            q[corners == 2 ? at(n - s) : index(k, s)] = row[at(n - s)];
            for (int j = 0; j < n - s; ++j) row[at(j)] = (row[at(j)] + row[at(j + 1)]) * 0.5;
        }
    }
}

// The square of the greatest length of a net's points after some bisections: an upper bound for the
// function that the net spans. Parts that cannot raise `most` are skipped.
template <int corners, class Net>
double longest_squared(const Net& net, auto degree, int levels, double most)
{
    double here = 0;
    for (int i = 0; i < net_size<corners>(degree); ++i) {
        const double squared = glm::dot(net[at(i)], net[at(i)]);
        if (!(squared <= here))
            here = std::isnan(squared) ? std::numeric_limits<double>::infinity() : squared;
    }
    if (here <= most || levels == 0) return std::max(here, most);
    Net p, q;
    bisect<corners>(net, degree, p, q);
    most = longest_squared<corners>(p, degree, levels - 1, most);
    return longest_squared<corners>(q, degree, levels - 1, most);
}

} // namespace trivar
