// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/contact.h"

#include "core/base/mistake.h"
#include "core/spline/greville_grid.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double steepest_step = 3; // largest length that counts, relative to the visible length
// Distance from the line between the neighbours, relative to their distance
constexpr double sharpest_ridge = 0.5;

bool turns_sharply(const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after,
                   const glm::dvec3& direction)
{
    const glm::dvec3 gap = (after - before) / 2.0;
    const double seen = glm::length(gap - glm::dot(gap, direction) * direction);
    return std::abs(glm::dot(p - (before + after) / 2.0, direction)) > sharpest_ridge * seen;
}

} // namespace

bool creased(const Knots& knots, int control_point)
{
    const auto first = static_cast<std::size_t>(control_point) + 1;
    const auto last = static_cast<std::size_t>(control_point + knots.order()) - 1;
    return knots.values()[first] == knots.values()[last];
}

bool jumps(const std::array<Knots, 2>& axes, const std::vector<glm::dvec3>& nodes,
           const std::vector<glm::dvec3>& direction)
{
    const int rows = axes[0].count(), columns = axes[1].count();
    const auto at = [columns](int i, int j) {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(j);
    };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const std::size_t k = at(i, j);
            if (i > 0 && i + 1 < rows && !creased(axes[0], i) &&
                turns_sharply(nodes[at(i - 1, j)], nodes[k], nodes[at(i + 1, j)], direction[k]))
                return true;
            if (j > 0 && j + 1 < columns && !creased(axes[1], j) &&
                turns_sharply(nodes[at(i, j - 1)], nodes[k], nodes[at(i, j + 1)], direction[k]))
                return true;
        }
    return false;
}

Surface<glm::dvec3> contact_surface(const std::array<Knots, 2>& axes,
                                    const std::vector<glm::dvec3>& nodes, bool through_nodes)
{
    if (through_nodes) return GrevilleGrid(axes).through(nodes);
    return {axes, nodes};
}

std::vector<double> walked_length(const std::vector<glm::dvec3>& points,
                                  const std::vector<glm::dvec3>& view_direction)
{
    std::vector<double> out{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 step = points[i] - points[i - 1];
        const glm::dvec3 d = view_direction[i];
        const double seen = glm::length(step - glm::dot(step, d) * d);
        out.push_back(out.back() + std::min(glm::length(step), steepest_step * seen));
    }
    return out;
}

std::vector<double> at_length_shares(const std::vector<double>& length,
                                     const std::vector<double>& parameter,
                                     const std::vector<double>& shares)
{
    ensure(length.size() == parameter.size() && length.size() >= 2, "a curve has no length");
    std::vector<double> out;
    std::size_t i = 0;
    for (const double share : shares) {
        const double wanted = share * length.back();
        while (i + 2 < length.size() && length[i + 1] < wanted) ++i;
        const double step = length[i + 1] - length[i];
        const double f = step > 0 ? std::clamp((wanted - length[i]) / step, 0.0, 1.0) : 0.0;
        out.push_back(parameter[i] + f * (parameter[i + 1] - parameter[i]));
    }
    out.front() = parameter.front();
    out.back() = parameter.back();
    return out;
}

} // namespace trivar
