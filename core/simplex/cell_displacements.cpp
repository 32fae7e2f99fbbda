// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/cell_displacements.h"

#include "core/base/parallel.h"
#include "core/simplex/cell_polynomial.h"

namespace trivar {
namespace {

// Bezier coefficients of the polynomial of the degree of `to` with values at the nodes of `from`.
std::vector<glm::dvec3> raised(const CellInterpolation& from, int degree,
                               const CellInterpolation& to, std::span<const glm::dvec3> values)
{
    const std::vector<glm::dvec3> lower = from.coefficients(values);
    std::vector<glm::dvec3> out;
    for (const glm::dvec4& node : to.nodes())
        out.push_back(from.polar_form(
            lower, std::vector<glm::dvec4>(static_cast<std::size_t>(degree), node)));
    return to.coefficients(out);
}

} // namespace

int degree_of(std::size_t values, std::size_t cells)
{
    for (int degree = 1; degree <= max_simplex_degree; ++degree)
        if (cells > 0 && values == cells * multi_indices<3>(degree).size()) return degree;
    return 0;
}

std::vector<glm::dvec3> control_displacements(const SimplexBasis<3>& basis,
                                              std::span<const glm::dvec3> values)
{
    const SimplexDomain<3>& domain = basis.domain();
    const auto indices = multi_indices<3>(domain.degree);
    const int degree = degree_of(values.size(), domain.cells.size());
    const std::size_t per_cell = values.size() / domain.cells.size();
    const CellInterpolation interpolation(domain.degree), given(degree);
    std::vector<glm::dvec3> by_function(domain.cells.size() * indices.size());
    parallel_blocks(domain.cells.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const auto of_cell = values.subspan(c * per_cell, per_cell);
            const auto coefficients = degree == domain.degree
                                          ? interpolation.coefficients(of_cell)
                                          : raised(given, degree, interpolation, of_cell);
            const auto at = corners(domain, c);
            const glm::dmat3 edges(at[1] - at[0], at[2] - at[0], at[3] - at[0]);
            const glm::dmat3 inverse = glm::inverse(edges);
            for (std::size_t b = 0; b < indices.size(); ++b) {
                std::vector<glm::dvec4> arguments; // knots (k, j) with j < b_k
                for (std::size_t k = 0; k < 4; ++k)
                    for (int j = 0; j < indices[b][k]; ++j) {
                        const glm::dvec3 l = inverse * (domain.knot(domain.cells[c][k], j) - at[0]);
                        arguments.emplace_back(1 - l.x - l.y - l.z, l.x, l.y, l.z);
                    }
                by_function[c * indices.size() + b] =
                    interpolation.polar_form(coefficients, arguments);
            }
        }
    });
    // Functions that share a control point agree on it, but for rounding.
    std::vector<glm::dvec3> out(basis.point_count(), glm::dvec3(0));
    std::vector<int> count(out.size(), 0);
    for (std::size_t i = 0; i < by_function.size(); ++i) {
        const auto p =
            static_cast<std::size_t>(basis.point_of(i / indices.size(), i % indices.size()));
        out[p] += by_function[i];
        ++count[p];
    }
    for (std::size_t p = 0; p < out.size(); ++p) out[p] /= static_cast<double>(count[p]);
    return out;
}

} // namespace trivar
