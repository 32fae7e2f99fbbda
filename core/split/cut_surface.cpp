// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/cut_surface.h"

#include "core/base/rejected.h"

#include <Eigen/Cholesky>

namespace trivar {
namespace {

constexpr int surface_points = 9;   // control points along either axis
constexpr int shadow_columns = 64;  // columns along either axis of the obstacle's shadow
constexpr double smoothness = 1e-3; // weight of the penalty, per sample

std::array<Knots, 2> axes_over(const SplitRectangle& rectangle)
{
    const glm::dvec2 more = 0.05 * (rectangle.hi - rectangle.lo);
    return {Knots::uniform(4, surface_points, rectangle.lo.x - more.x, rectangle.hi.x + more.x),
            Knots::uniform(4, surface_points, rectangle.lo.y - more.y, rectangle.hi.y + more.y)};
}

struct Middle {
    glm::dvec2 vw;
    double u;
};

std::vector<Middle> middles(const ObstacleColumns& columns)
{
    const Box& box = columns.box();
    std::vector<glm::dvec2> at;
    for (int i = 0; i < shadow_columns; ++i)
        for (int j = 0; j < shadow_columns; ++j)
            at.push_back(glm::dvec2(box.lo.y, box.lo.z) +
                         glm::dvec2(i + 0.5, j + 0.5) / double{shadow_columns} *
                             glm::dvec2(box.size().y, box.size().z));
    const std::vector<std::optional<glm::dvec2>> extents = columns.at(at);
    std::vector<Middle> out;
    for (std::size_t k = 0; k < at.size(); ++k)
        if (extents[k]) out.push_back({at[k], (extents[k]->x + extents[k]->y) / 2});
    if (out.empty())
        throw Rejected(
            "is too thin to split round; choose a thicker obstacle, or turn the directions of the "
            "split");
    return out;
}

double mean_of(const std::vector<Middle>& all)
{
    double sum = 0;
    for (const Middle& m : all) sum += m.u;
    return sum / static_cast<double>(all.size());
}

} // namespace

CutSurface middle_surface(const ObstacleColumns& columns, const SplitRectangle& over)
{
    const std::vector<Middle> all = middles(columns);
    CutSurface out{axes_over(over), {}};
    constexpr int unknowns = surface_points * surface_points;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(unknowns, unknowns) * 1e-12;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    // About the mean, so that where nothing is known the surface stays near it
    const double mean = mean_of(all);
    for (const Middle& m : all) {
        const Basis a = basis(out.axes[0], m.vw.x), b = basis(out.axes[1], m.vw.y);
        std::array<double, 16> weight{};
        std::array<int, 16> index{};
        for (std::size_t k = 0; k < 16; ++k) {
            weight[k] = a.value[k / 4] * b.value[k % 4];
            index[k] = (a.first + static_cast<int>(k / 4)) * surface_points + b.first +
                       static_cast<int>(k % 4);
        }
        for (std::size_t k = 0; k < 16; ++k) {
            right[index[k]] += weight[k] * (m.u - mean);
            for (std::size_t l = 0; l < 16; ++l)
                normal(index[k], index[l]) += weight[k] * weight[l];
        }
    }
    const double penalty = smoothness * static_cast<double>(all.size());
    const auto penalise = [&](std::initializer_list<std::pair<int, double>> row) {
        for (const auto& [i, x] : row)
            for (const auto& [j, y] : row) normal(i, j) += penalty * x * y;
    };
    for (int i = 0; i < surface_points; ++i)
        for (int j = 0; j < surface_points; ++j) {
            const int at = i * surface_points + j;
            if (i > 0 && i + 1 < surface_points)
                penalise({{at - surface_points, 1}, {at, -2}, {at + surface_points, 1}});
            if (j > 0 && j + 1 < surface_points) penalise({{at - 1, 1}, {at, -2}, {at + 1, 1}});
            if (i + 1 < surface_points && j + 1 < surface_points) {
                constexpr double twist = 1.4142135623730951;
                penalise({{at, twist},
                          {at + surface_points, -twist},
                          {at + 1, -twist},
                          {at + surface_points + 1, twist}});
            }
        }
    const Eigen::VectorXd solved = normal.ldlt().solve(right);
    for (int k = 0; k < unknowns; ++k) out.points.push_back(mean + solved[k]);
    return out;
}

} // namespace trivar
