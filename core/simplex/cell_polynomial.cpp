// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/cell_polynomial.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

double bernstein(const MultiIndex<3>& index, const glm::dvec4& l)
{
    double out = 1;
    int total = 0;
    for (int k = 0; k < 4; ++k)
        for (int i = 1; i <= index[static_cast<std::size_t>(k)]; ++i) out *= l[k] * ++total / i;
    return out;
}

} // namespace

CellInterpolation::CellInterpolation(int degree) : degree_(degree)
{
    const auto indices = multi_indices<3>(degree);
    for (const auto& b : indices)
        nodes_.push_back(glm::dvec4(b[0], b[1], b[2], b[3]) / static_cast<double>(degree));
    const auto count = static_cast<Eigen::Index>(nodes_.size());
    Eigen::MatrixXd at(count, count);
    for (Eigen::Index row = 0; row < count; ++row)
        for (Eigen::Index column = 0; column < count; ++column)
            at(row, column) = bernstein(indices[static_cast<std::size_t>(column)],
                                        nodes_[static_cast<std::size_t>(row)]);
    const Eigen::MatrixXd inverse = at.inverse();
    for (Eigen::Index row = 0; row < count; ++row)
        for (Eigen::Index column = 0; column < count; ++column)
            inverse_.push_back(inverse(row, column));
}

std::vector<glm::dvec3> CellInterpolation::coefficients(std::span<const glm::dvec3> values) const
{
    std::vector<glm::dvec3> out(values.size(), glm::dvec3(0));
    for (std::size_t row = 0; row < out.size(); ++row)
        for (std::size_t column = 0; column < out.size(); ++column)
            out[row] += values[column] * inverse_[row * out.size() + column];
    return out;
}

// Makes de Casteljau's steps, each with another argument: each leaves a polynomial of one degree
// less.
glm::dvec3 CellInterpolation::polar_form(std::span<const glm::dvec3> coefficients,
                                         std::span<const glm::dvec4> arguments) const
{
    std::vector<glm::dvec3> now(coefficients.begin(), coefficients.end());
    auto indices = multi_indices<3>(degree_);
    for (int degree = degree_; degree > 1; --degree) {
        const auto lower = multi_indices<3>(degree - 1);
        std::vector<glm::dvec3> next;
        for (MultiIndex<3> b : lower) {
            glm::dvec3 sum(0);
            for (std::size_t k = 0; k < 4; ++k) {
                ++b[k];
                const auto at = std::find(indices.begin(), indices.end(), b) - indices.begin();
                sum += now[static_cast<std::size_t>(at)] *
                       arguments[static_cast<std::size_t>(degree - 1)][static_cast<int>(k)];
                --b[k];
            }
            next.push_back(sum);
        }
        now = std::move(next);
        indices = lower;
    }
    glm::dvec3 out(0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            if (indices[i][k] == 1) out += now[i] * arguments[0][static_cast<int>(k)];
    return out;
}

} // namespace trivar
