// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_domain.h"

#include "core/base/rejected.h"
#include "core/simplex/multi_index.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

template <int S> bool less(const glm::vec<S, double>& a, const glm::vec<S, double>& b)
{
    for (int i = 0; i < S; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return false;
}

template <int S> void check_vertices(const SimplexDomain<S>& domain)
{
    std::vector<glm::vec<S, double>> vertices;
    for (std::size_t v = 0; v < domain.vertex_count(); ++v)
        vertices.push_back(domain.vertex(static_cast<int>(v)));
    std::sort(vertices.begin(), vertices.end(), less<S>);
    if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
        throw Rejected("Two vertices of the domain are at the same place.");
}

} // namespace

double orientation(const std::array<glm::dvec2, 3>& c)
{
    const glm::dvec2 a = c[1] - c[0], b = c[2] - c[0];
    return a.x * b.y - a.y * b.x;
}

double orientation(const std::array<glm::dvec3, 4>& c)
{
    return glm::dot(c[1] - c[0], glm::cross(c[2] - c[0], c[3] - c[0]));
}

template <int S> void check(const SimplexDomain<S>& domain)
{
    if (domain.degree < 1 || domain.degree > max_simplex_degree)
        throw Rejected(
            fmt::format("The degree of a simplex spline is 1 to 3, not {}.", domain.degree));
    for (const auto& knot : domain.knots)
        for (int i = 0; i < S; ++i)
            if (!std::isfinite(knot[i])) throw Rejected("A knot of the domain is not a number.");
    if (domain.knots.size() % static_cast<std::size_t>(domain.knots_per_vertex()) != 0)
        throw Rejected("Each vertex of the domain needs as many knots as the degree, plus one.");
    const int vertices = static_cast<int>(domain.vertex_count());
    for (const auto& cell : domain.cells)
        for (const int v : cell)
            if (v < 0 || v >= vertices)
                throw Rejected(
                    fmt::format("A cell of the domain names vertex {} of {}.", v, vertices));
    check_vertices(domain);
    for (std::size_t c = 0; c < domain.cells.size(); ++c) {
        if (!(orientation(corners(domain, c)) > 0))
            throw Rejected(fmt::format("Cell {} of the domain is flat or inverted.", c));
        for (const MultiIndex<S>& index : multi_indices<S>(domain.degree)) {
            auto x = corners(domain, c);
            for (std::size_t k = 0; k < x.size(); ++k)
                x[k] = domain.knot(domain.cells[c][k], index[k]);
            if (!(orientation(x) > 0))
                throw Rejected(fmt::format("The knot clouds at cell {} of the domain cross.", c));
        }
    }
}

template void check(const SimplexDomain<2>&);
template void check(const SimplexDomain<3>&);

} // namespace trivar
