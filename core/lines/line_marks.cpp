// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/line_marks.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

constexpr float least_cell = 2;  // pixels
constexpr int most_cells = 2048; // along an axis

// A CellGrid lists the segments of curves by the cells of the image through whose box they go.
class CellGrid {
public:
    explicit CellGrid(const ImageCurves& curves) : curves_(curves)
    {
        glm::vec2 lo(1e30f), hi(-1e30f);
        for (const StrokePoint& p : curves.points) {
            lo = glm::min(lo, p.at);
            hi = glm::max(hi, p.at);
        }
        const glm::vec2 extent = hi - lo;
        cell_ = std::max(least_cell, std::max(extent.x, extent.y) / float{most_cells});
        origin_ = lo;
        size_ = glm::ivec2(extent / cell_) + 1;
        begin_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) + 1, 0);
        for (std::uint32_t i = 0; i < curves.points.size(); ++i)
            for_cells(i, [&](std::size_t c) { ++begin_[c + 1]; });
        for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
        segments_.resize(begin_.back());
        std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
        for (std::uint32_t i = 0; i < curves.points.size(); ++i)
            for_cells(i, [&](std::size_t c) { segments_[at[c]++] = i; });
    }
    int rows() const { return size_.y; }
    int columns() const { return size_.x; }
    std::span<const std::uint32_t> in(int x, int y) const
    {
        const std::size_t c = number(x, y);
        return std::span(segments_).subspan(begin_[c], begin_[c + 1] - begin_[c]);
    }
    glm::ivec2 cell_of(const glm::vec2& p) const
    {
        return glm::clamp(glm::ivec2((p - origin_) / cell_), glm::ivec2(0), size_ - 1);
    }

private:
    std::size_t number(int x, int y) const
    {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(y);
    }
    void for_cells(std::uint32_t i, auto&& use) const
    {
        const std::uint32_t j = curves_.next[i];
        if (j == ImageCurves::none) return;
        const glm::vec2 &a = curves_.points[i].at, &b = curves_.points[j].at;
        const glm::ivec2 first = cell_of(glm::min(a, b)), last = cell_of(glm::max(a, b));
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) use(number(x, y));
    }

    const ImageCurves& curves_;
    float cell_;
    glm::vec2 origin_;
    glm::ivec2 size_;
    std::vector<std::uint32_t> begin_, segments_; // by cell
};

// The mark on the farther of two segments that cross in this cell.
std::optional<LineMark> crossing(const ImageCurves& curves, const CellGrid& grid,
                                 const glm::ivec2& cell, std::uint32_t i, std::uint32_t j)
{
    const std::uint32_t i2 = curves.next[i], j2 = curves.next[j];
    if (i2 == j || j2 == i) return std::nullopt;
    const StrokePoint &a = curves.points[i], &a2 = curves.points[i2], &b = curves.points[j],
                      &b2 = curves.points[j2];
    const glm::dvec2 u = a2.at - a.at, v = b2.at - b.at, d = b.at - a.at;
    const double det = u.x * v.y - u.y * v.x;
    if (det == 0) return std::nullopt;
    const double s = (d.x * v.y - d.y * v.x) / det, t = (d.x * u.y - d.y * u.x) / det;
    if (s < 0 || s >= 1 || t < 0 || t >= 1) return std::nullopt;
    if (grid.cell_of(glm::vec2(glm::dvec2(a.at) + s * u)) != cell) return std::nullopt;
    const double depth_a = a.depth + s * (a2.depth - a.depth),
                 depth_b = b.depth + t * (b2.depth - b.depth);
    return depth_a > depth_b ? LineMark{i, static_cast<float>(s)}
                             : LineMark{j, static_cast<float>(t)};
}

} // namespace

ImageCurves in_image(const Silhouettes& silhouettes, const glm::dmat4& to_image)
{
    ImageCurves out{{}, silhouettes.first, silhouettes.closed, {}};
    out.points.reserve(silhouettes.points.size());
    for (const SilhouettePoint& point : silhouettes.points) {
        const glm::dvec4 q = to_image * glm::dvec4(glm::dvec3(point.p), 1);
        out.points.push_back({.at = glm::vec2(glm::dvec2(q) / q.w),
                              .depth = static_cast<float>(q.z / q.w),
                              .slope = point.slope,
                              .bend = point.bend,
                              .p = point.p,
                              .strength = point.strength});
    }
    out.next.resize(out.points.size());
    for (std::size_t c = 0; c < silhouettes.count(); ++c)
        for (std::uint32_t i = out.first[c]; i < out.first[c + 1]; ++i)
            out.next[i] = i + 1 < out.first[c + 1] ? i + 1
                          : out.closed[c]          ? out.first[c]
                                                   : ImageCurves::none;
    return out;
}

std::vector<LineMark> line_marks(const ImageCurves& curves)
{
    std::vector<LineMark> out;
    if (curves.points.empty()) return out;
    const CellGrid grid(curves);
    std::vector<std::vector<LineMark>> by_row(static_cast<std::size_t>(grid.rows()));
    parallel_blocks(by_row.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row)
            for (int x = 0; x < grid.columns(); ++x) {
                const glm::ivec2 cell(x, static_cast<int>(row));
                const std::span<const std::uint32_t> in = grid.in(cell.x, cell.y);
                for (std::size_t a = 0; a < in.size(); ++a)
                    for (std::size_t b = a + 1; b < in.size(); ++b)
                        if (const auto mark = crossing(curves, grid, cell, in[a], in[b]))
                            by_row[row].push_back(*mark);
            }
    });
    for (const std::vector<LineMark>& row : by_row) out.insert(out.end(), row.begin(), row.end());
    for (std::uint32_t i = 0; i < curves.points.size(); ++i) {
        if (curves.next[i] == ImageCurves::none) continue;
        const float a = curves.points[i].bend, b = curves.points[curves.next[i]].bend;
        if ((a > 0) != (b > 0)) out.push_back({i, a / (a - b)});
    }
    std::ranges::sort(out, [](const LineMark& a, const LineMark& b) {
        return a.point != b.point ? a.point < b.point : a.share < b.share;
    });
    return out;
}

} // namespace trivar
