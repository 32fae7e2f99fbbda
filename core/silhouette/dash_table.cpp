// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/dash_table.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/polish.h"
#include "core/silhouette/silhouette_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

constexpr float dash_length = 0.8f; // voxels

// Points that are spread evenly over a sphere [Vogel 1979; Fibonacci lattice].
std::vector<glm::vec3> even_directions(int count)
{
    std::vector<glm::vec3> out;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z),
                     turn = i * glm::pi<double>() * (3 - std::sqrt(5.0));
        out.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return out;
}

// No direction is farther from the nearest of so many.
float covering_angle(int count)
{
    return static_cast<float>(3.1 / std::sqrt(static_cast<double>(count)));
}

// The range of the coefficients of a cell, and that of their differences along each axis.
struct CellNet {
    float least = 1e30f, greatest = -1e30f;
    glm::vec3 lo{1e30f}, hi{-1e30f}; // of the gradients
};

CellNet net_of(const ScalarField<float>& field, const glm::ivec3& cell)
{
    CellNet out;
    for (int k = -1; k <= 2; ++k)
        for (int j = -1; j <= 2; ++j)
            for (int i = -1; i <= 2; ++i) {
                const glm::ivec3 at = cell + glm::ivec3(i, j, k);
                const float c = field.coefficient(at.x, at.y, at.z);
                out.least = std::min(out.least, c);
                out.greatest = std::max(out.greatest, c);
                const auto add = [&](int axis, float other) {
                    out.lo[axis] = std::min(out.lo[axis], other - c);
                    out.hi[axis] = std::max(out.hi[axis], other - c);
                };
                if (i < 2) add(0, field.coefficient(at.x + 1, at.y, at.z));
                if (j < 2) add(1, field.coefficient(at.x, at.y + 1, at.z));
                if (k < 2) add(2, field.coefficient(at.x, at.y, at.z + 1));
            }
    return out;
}

float angle_between(const glm::vec3& a, const glm::vec3& b) // unit
{
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

} // namespace

DashTable::DashTable(const ScalarField<float>& field, const FieldHulls& hulls, float level,
                     int rows)
    : level_(level),
      covering_(covering_angle(std::max(rows, 1))),
      rows_(even_directions(std::max(rows, 1)))
{
    if (field.order() != FieldOrder::cubic)
        throw Rejected("dashes are of cubic splines, this one is of another order");
    const glm::ivec3 cells = field.size() - 1;
    std::vector<std::vector<Cone>> by_slice(static_cast<std::size_t>(cells.z));
    parallel_blocks(by_slice.size(), 1, [&](std::size_t z, std::size_t) {
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) {
                const glm::ivec3 cell(x, y, static_cast<int>(z));
                const FieldHulls::Range& range = hulls.of(cell / FieldHulls::brick);
                if (range.least > level || range.greatest < level) continue;
                const CellNet net = net_of(field, cell);
                if (net.least > level || net.greatest < level) continue;
                Cone cone{cell, (net.lo + net.hi) / 2.0f, 0};
                const float length = glm::length(cone.axis);
                cone.axis = length > 0 ? cone.axis / length : glm::vec3(0, 0, 1);
                for (int c = 0; c < 8; ++c) {
                    const glm::vec3 g(c & 1 ? net.hi.x : net.lo.x, c & 2 ? net.hi.y : net.lo.y,
                                      c & 4 ? net.hi.z : net.lo.z);
                    const float norm = glm::length(g), along = glm::dot(g, cone.axis);
                    cone.half_angle =
                        along > 0 && length > 0
                            ? std::max(cone.half_angle, angle_between(g / norm, cone.axis))
                            : glm::pi<float>();
                    if (cone.half_angle == glm::pi<float>()) break;
                }
                by_slice[z].push_back(cone);
            }
    });
    for (const std::vector<Cone>& slice : by_slice)
        cones_.insert(cones_.end(), slice.begin(), slice.end());
    std::vector<std::vector<std::uint32_t>> of_row(rows_.size());
    parallel_blocks(rows_.size(), 1, [&](std::size_t r, std::size_t) {
        for (std::uint32_t c = 0; c < cones_.size(); ++c)
            if (angle_between(rows_[r], cones_[c].axis) <= cones_[c].half_angle + covering_)
                of_row[r].push_back(c);
    });
    first_.push_back(0);
    for (const std::vector<std::uint32_t>& row : of_row) {
        cells_.insert(cells_.end(), row.begin(), row.end());
        first_.push_back(static_cast<std::uint32_t>(cells_.size()));
    }
}

std::vector<std::uint32_t> DashTable::candidate_cells(const glm::dvec3& sight) const
{
    const glm::vec3 along(glm::normalize(sight));
    std::vector<std::uint32_t> out;
    for (std::size_t r = 0; r < rows_.size(); ++r)
        if (std::abs(glm::dot(rows_[r], along)) <= std::sin(std::min(covering_, 1.57f)))
            out.insert(out.end(), cells_.begin() + first_[r], cells_.begin() + first_[r + 1]);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::size_t DashTable::candidates(const ViewPoint& view) const
{
    return candidate_cells(view.sight({})).size();
}

std::size_t DashTable::bytes() const
{
    return cones_.size() * sizeof(Cone) + (cells_.size() + first_.size()) * sizeof(std::uint32_t);
}

Silhouettes DashTable::operator()(const ScalarField<float>& field, const ViewPoint& view) const
{
    check(view);
    if (view.at.w != 0) throw Rejected("dashes are of parallel views, this one is from an eye");
    const std::vector<std::uint32_t> candidates = candidate_cells(view.sight({}));
    Silhouettes out;
    out.tested = candidates.size();
    for (const std::uint32_t c : candidates) {
        const glm::vec3 corner(cones_[c].cell);
        SilhouettePoint middle{.p = corner + 0.5f, .edge = 2 * std::uint64_t{c}};
        finish(field, level_, view, true, std::span(&middle, 1));
        if (!middle.polished || glm::any(glm::lessThan(middle.p, corner)) ||
            glm::any(glm::greaterThan(middle.p, corner + 1.0f)))
            continue;
        // The silhouette runs at right angles to both gradients: of D, and of <V, grad D>.
        const ScalarJet<float> jet = field.at<2>(middle.p);
        const glm::vec3 way = glm::cross(gradient_of(jet), hessian_of(jet) * glm::vec3(view.at));
        const float norm = glm::length(way);
        if (!(norm > 0)) continue;
        for (const float side : {-0.5f, 0.5f}) {
            SilhouettePoint end = middle;
            end.p =
                glm::clamp(middle.p + side * dash_length / norm * way, glm::vec3(0), field.end());
            end.edge += side > 0;
            out.points.push_back(end);
        }
        out.first.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.closed.push_back(0);
    }
    return out;
}

} // namespace trivar
