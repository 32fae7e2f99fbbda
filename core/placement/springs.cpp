// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/springs.h"

#include "core/base/finite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace trivar {
namespace {

// Returns the length of the axis for which each node stands: half way to its neighbours.
std::vector<double> dual_lengths(const std::vector<double>& x)
{
    std::vector<double> out(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        out[i] = (x[std::min(i + 1, x.size() - 1)] - x[i > 0 ? i - 1 : 0]) / 2;
    return out;
}

// An Assembly holds the rows of A and b while they are summed up; a node is coupled to those one
// and two steps away.
class Assembly {
public:
    explicit Assembly(const SpringSheet& sheet)
        : sheet_(sheet),
          coupling_(sheet.p0.size()),
          diagonal_(sheet.p0.size(), 0),
          right_(sheet.p0.size(), 0)
    {
    }

    // Adds the energy weight / 2 s^2.
    void pull(std::size_t node, double weight) { diagonal_[node] += weight; }

    // Adds the energy weight / 2 |sum_m c_m P_m|^2 over nodes a step of `stride` apart along one
    // axis.
    template <std::size_t N>
    void add(double weight, int first, int stride, int axis, const std::array<double, N>& c)
    {
        glm::dvec3 rest(0);
        for (std::size_t m = 0; m < N; ++m) rest += c[m] * sheet_.p0[node(first, stride, m)];
        for (std::size_t m = 0; m < N; ++m) {
            const std::size_t a = node(first, stride, m);
            const glm::dvec3& va = sheet_.direction[a];
            diagonal_[a] += weight * c[m] * c[m];
            right_[a] -= weight * c[m] * glm::dot(rest, va);
            for (std::size_t k = 0; k < N; ++k) {
                if (k == m) continue;
                const std::size_t slot =
                    static_cast<std::size_t>(axis) * 4 + (k > m ? 1 + k - m : 2 - (m - k));
                coupling_[a][slot] +=
                    weight * c[m] * c[k] * glm::dot(va, sheet_.direction[node(first, stride, k)]);
            }
        }
    }

    ObstacleProblem problem() const
    {
        ObstacleProblem out;
        const int row = sheet_.columns;
        const std::array<int, 8> offset{-2 * row, -row, row, 2 * row, -2, -1, 1, 2};
        for (std::size_t a = 0; a < coupling_.size(); ++a) {
            for (std::size_t slot = 0; slot < 8; ++slot) {
                if (coupling_[a][slot] == 0) continue;
                out.column.push_back(static_cast<int>(a) + offset[slot]);
                out.value.push_back(coupling_[a][slot]);
            }
            out.row_begin.push_back(static_cast<int>(out.column.size()));
        }
        out.diagonal = diagonal_;
        out.right = right_;
        out.lo = sheet_.lo;
        out.hi = sheet_.hi;
        out.free.assign(coupling_.size(), 1);
        return out;
    }

private:
    static std::size_t node(int first, int stride, std::size_t step)
    {
        return static_cast<std::size_t>(first) + static_cast<std::size_t>(stride) * step;
    }
    const SpringSheet& sheet_;
    // Couplings of each node with the nodes 2 and 1 before, 1 and 2 after, along the rows, then
    // along the columns.
    std::vector<std::array<double, 8>> coupling_;
    std::vector<double> diagonal_, right_;
};

std::vector<char> dilated(const std::vector<char>& nodes, int rows, int columns, int steps)
{
    // A square neighbourhood is built along the rows first, then along the columns.
    const auto along = [steps](const std::vector<char>& in, int count, int lines, int step,
                               int line_step) {
        std::vector<char> out(in.size(), 0);
        for (int line = 0; line < lines; ++line)
            for (int i = 0, until = -1; i < count + steps; ++i) {
                const auto at = [&](int k) {
                    return static_cast<std::size_t>(line * line_step + k * step);
                };
                if (i < count && in[at(i)]) until = i + 2 * steps;
                if (i >= steps && i <= until) out[at(i - steps)] = 1;
            }
        return out;
    };
    return along(along(nodes, rows, columns, columns, 1), columns, rows, 1, columns);
}

} // namespace

ObstacleProblem spring_problem(const SpringSheet& sheet)
{
    Assembly sum(sheet);
    const std::vector<double> along = dual_lengths(sheet.along);
    const std::vector<double> across = dual_lengths(sheet.across);
    const auto bend = [](const std::vector<double>& x, std::size_t i) {
        // The second difference is twice the distance from the line between the neighbours.
        const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
        return std::array{-2 * right / (left + right), 2.0, -2 * left / (left + right)};
    };
    for (int i = 0; i < sheet.rows; ++i)
        for (int j = 0; j < sheet.columns; ++j) {
            const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
            const int k = static_cast<int>(sheet.index(i, j));
            const int row = sheet.columns;
            sum.pull(sheet.index(i, j), sheet.pull * along[I] * across[J]);
            if (i + 1 < sheet.rows)
                sum.add(across[J] / (sheet.along[I + 1] - sheet.along[I]), k, row, 0,
                        std::array{-1.0, 1.0});
            if (j + 1 < sheet.columns)
                sum.add(along[I] / (sheet.across[J + 1] - sheet.across[J]), k, 1, 1,
                        std::array{-1.0, 1.0});
            if (sheet.bending > 0 && i > 0 && i + 1 < sheet.rows)
                sum.add(sheet.bending, k - row, row, 0, bend(sheet.along, I));
            if (sheet.bending > 0 && j > 0 && j + 1 < sheet.columns)
                sum.add(sheet.bending, k - 1, 1, 1, bend(sheet.across, J));
        }
    return sum.problem();
}

ObstacleProblem grid_laplacian(int rows, int columns)
{
    ObstacleProblem out;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            double neighbors = 0;
            for (const auto& [di, dj] : {std::pair{-1, 0}, {0, -1}, {0, 1}, {1, 0}}) {
                if (i + di < 0 || j + dj < 0 || i + di >= rows || j + dj >= columns) continue;
                out.column.push_back((i + di) * columns + j + dj);
                out.value.push_back(-1);
                ++neighbors;
            }
            out.row_begin.push_back(static_cast<int>(out.column.size()));
            out.diagonal.push_back(neighbors);
        }
    out.right.assign(out.size(), 0);
    out.lo.assign(out.size(), -infinite);
    out.hi.assign(out.size(), infinite);
    out.free.assign(out.size(), 1);
    return out;
}

std::vector<int> red_black(int rows, int columns)
{
    std::vector<int> order;
    order.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    for (int color = 0; color < 2; ++color)
        for (int i = 0; i < rows; ++i)
            for (int j = (i + color) % 2; j < columns; j += 2) order.push_back(i * columns + j);
    return order;
}

double over_relaxation(int rows, int columns)
{
    // The relaxation factor is that of a square grid [Young 1954]; a free rim acts like a grid of
    // twice the size.
    const int n = std::max(rows, columns);
    return 2 / (1 + std::sin(std::acos(-1.0) / n));
}

std::vector<char> rough_nodes(const SpringSheet& sheet, const std::vector<double>& s,
                              double roughness_deg)
{
    const double limit = std::cos(roughness_deg * std::acos(-1.0) / 180);
    std::vector<char> out(s.size(), 0);
    std::vector<glm::dvec3> p(s.size());
    for (std::size_t k = 0; k < s.size(); ++k) p[k] = sheet.point(k, s);
    constexpr std::array<std::array<int, 2>, 4> around{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    for (int i = 0; i < sheet.rows; ++i)
        for (int j = 0; j < sheet.columns; ++j) {
            std::array<glm::dvec3, 4> normal;
            std::size_t count = 0;
            const std::size_t k = sheet.index(i, j);
            if (!sheet.on_edge.empty() && sheet.on_edge[k]) continue;
            for (std::size_t q = 0; q < 4; ++q) {
                const auto [ai, aj] = around[q];
                const auto [bi, bj] = around[(q + 1) % 4];
                const int di = ai + bi, dj = aj + bj; // the far corner of the face
                if (i + di < 0 || j + dj < 0 || i + di >= sheet.rows || j + dj >= sheet.columns)
                    continue;
                const glm::dvec3 n = glm::cross(p[sheet.index(i + ai, j + aj)] - p[k],
                                                p[sheet.index(i + bi, j + bj)] - p[k]);
                const double length = glm::length(n);
                if (length > 0) normal[count++] = n / length;
            }
            for (std::size_t m = 0; m < count; ++m)
                for (std::size_t q = 0; q < m; ++q)
                    if (glm::dot(normal[m], normal[q]) < limit) out[k] = 1;
        }
    return out;
}

RestShape rest_shape(const SpringSheet& sheet, std::vector<double> s, const RestOptions& options)
{
    // While loose nodes are still being added, an approximate shape suffices.
    constexpr int growing_sweeps = 20;
    ObstacleProblem problem = spring_problem(sheet);
    RestShape out;
    out.loose.assign(s.size(), 0);
    const std::vector<int> order = red_black(sheet.rows, sheet.columns);
    const double omega = over_relaxation(sheet.rows, sheet.columns);
    const auto solve = [&](int sweeps) {
        problem.free = out.loose;
        ObstacleSolution solved =
            projected_sor(problem, std::move(s), order, omega, options.tolerance, sweeps);
        s = std::move(solved.s);
        out.sweeps += solved.sweeps;
        out.residual = solved.residual;
    };
    for (bool settled = false; out.sweeps < options.most_sweeps;) {
        std::vector<char> loose = dilated(rough_nodes(sheet, s, options.roughness_deg), sheet.rows,
                                          sheet.columns, options.neighborhood);
        if (!options.free_ends)
            for (int j = 0; j < sheet.columns; ++j)
                loose[sheet.index(0, j)] = loose[sheet.index(sheet.rows - 1, j)] = 0;
        bool grown = false;
        for (std::size_t k = 0; k < s.size(); ++k) {
            grown = grown || (loose[k] && !out.loose[k]);
            out.loose[k] = out.loose[k] || loose[k];
        }
        if (!grown && (settled || std::count(out.loose.begin(), out.loose.end(), 1) == 0)) break;
        solve(grown ? growing_sweeps : options.most_sweeps - out.sweeps);
        settled = !grown;
    }
    out.s = std::move(s);
    return out;
}

} // namespace trivar
