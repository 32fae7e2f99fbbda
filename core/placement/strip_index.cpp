// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

// Barycentric coordinates of q in a triangle with the right angle of its parameters at a: the
// shares of b and c. Far outside for a triangle without area.
glm::dvec2 shares(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 q)
{
    const double area = cross(b - a, c - a);
    if (area == 0) return glm::dvec2(-1);
    return glm::dvec2(cross(q - a, c - a), cross(b - a, q - a)) / area;
}

} // namespace

StripIndex::StripIndex(const Surface<glm::dvec3>& surface, const View& view, glm::ivec2 steps)
    : steps_(steps),
      lo_(1e300),
      hi_(-1e300)
{
    std::vector<glm::dvec3> corners;
    for (int i = 0; i <= steps.x; ++i)
        for (int j = 0; j <= steps.y; ++j) {
            const glm::dvec2 uv(static_cast<double>(i) / steps.x, static_cast<double>(j) / steps.y);
            corners.push_back(evaluate(surface, uv).value);
            const glm::dvec2 p = view.project(corners.back()).p_px;
            corners_px_.push_back(p);
            lo_ = glm::min(lo_, p);
            hi_ = glm::max(hi_, p);
        }
    const glm::dvec2 size = glm::max(hi_ - lo_, glm::dvec2(1e-9));
    const double quads = static_cast<double>(steps.x) * steps.y;
    quad_px_ = std::sqrt(size.x * size.y / quads);
    buckets_ = glm::clamp(glm::ivec2(size / quad_px_), glm::ivec2(1), glm::ivec2(512));
    buckets_per_px_ = glm::dvec2(buckets_) / size;

    // Two passes: count the quads of each bucket, then write them behind one another.
    const auto each = [&](const auto& visit) {
        for (int i = 0; i < steps.x; ++i)
            for (int j = 0; j < steps.y; ++j) {
                glm::dvec2 lo(1e300), hi(-1e300);
                const int a = i * (steps.y + 1) + j;
                for (const int k : {a, a + 1, a + steps.y + 1, a + steps.y + 2}) {
                    lo = glm::min(lo, corners_px_[static_cast<std::size_t>(k)]);
                    hi = glm::max(hi, corners_px_[static_cast<std::size_t>(k)]);
                }
                const glm::ivec2 most = buckets_ - 1;
                const glm::ivec2 from =
                    glm::clamp(glm::ivec2((lo - lo_) * buckets_per_px_), glm::ivec2(0), most);
                const glm::ivec2 to =
                    glm::clamp(glm::ivec2((hi - lo_) * buckets_per_px_), glm::ivec2(0), most);
                for (int y = from.y; y <= to.y; ++y)
                    for (int x = from.x; x <= to.x; ++x)
                        visit(static_cast<std::size_t>(y * buckets_.x + x), i * steps.y + j);
            }
    };
    begin_.assign(static_cast<std::size_t>(buckets_.x * buckets_.y) + 1, 0);
    each([&](std::size_t b, int) { ++begin_[b + 1]; });
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    quads_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    const std::vector<double> sag = sags(corners, steps.x + 1, steps.y + 1, view);
    sag_.assign(begin_.size() - 1, 0);
    each([&](std::size_t b, int quad) {
        quads_[static_cast<std::size_t>(next[b]++)] = quad;
        const int corner = quad / steps.y * (steps.y + 1) + quad % steps.y;
        for (const int k : {corner, corner + 1, corner + steps.y + 1, corner + steps.y + 2})
            sag_[b] = std::max(sag_[b], sag[static_cast<std::size_t>(k)]);
    });
}

std::vector<double> sags(const std::vector<glm::dvec3>& points, int rows, int columns,
                         const View& view)
{
    std::vector<double> out(points.size(), 0);
    const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(i * columns + j)]; };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const glm::dvec3 p = at(i, j);
            const glm::dvec3 toward = view.toward_eye(p);
            double sum = 0;
            // Half way to a neighbour a parabola is off its chord by a quarter of this; twice that
            // is for what is no parabola.
            if (i > 0 && i + 1 < rows)
                sum += std::max(0.0, glm::dot((at(i - 1, j) + at(i + 1, j)) / 2.0 - p, toward));
            if (j > 0 && j + 1 < columns)
                sum += std::max(0.0, glm::dot((at(i, j - 1) + at(i, j + 1)) / 2.0 - p, toward));
            out[static_cast<std::size_t>(i * columns + j)] = sum / 2;
        }
    return out;
}

std::size_t StripIndex::bucket(glm::dvec2 p_px) const
{
    const glm::ivec2 at =
        glm::clamp(glm::ivec2((p_px - lo_) * buckets_per_px_), glm::ivec2(0), buckets_ - 1);
    return static_cast<std::size_t>(at.y * buckets_.x + at.x);
}

bool StripIndex::may_cover(glm::dvec2 p_px) const
{
    if (!(p_px.x >= lo_.x && p_px.y >= lo_.y && p_px.x <= hi_.x && p_px.y <= hi_.y)) return false;
    const std::size_t b = bucket(p_px);
    return begin_[b] < begin_[b + 1];
}

std::vector<glm::dvec2> StripIndex::find(glm::dvec2 p_px) const
{
    std::vector<glm::dvec2> out;
    if (!may_cover(p_px)) return out;
    constexpr double slack = 1e-6; // a pixel on the line between two quads is in both
    const std::size_t b = bucket(p_px);
    for (int e = begin_[b]; e < begin_[b + 1]; ++e) {
        const int quad = quads_[static_cast<std::size_t>(e)];
        const int i = quad / steps_.y, j = quad % steps_.y;
        const auto corner = [&](int di, int dj) {
            return corners_px_[static_cast<std::size_t>((i + di) * (steps_.y + 1) + j + dj)];
        };
        glm::dvec2 s = shares(corner(0, 0), corner(1, 0), corner(0, 1), p_px);
        if (s.x < -slack || s.y < -slack || s.x + s.y > 1 + slack) {
            s = shares(corner(1, 1), corner(0, 1), corner(1, 0), p_px);
            if (s.x < -slack || s.y < -slack || s.x + s.y > 1 + slack) continue;
            s = 1.0 - s;
        }
        out.emplace_back((i + s.x) / steps_.x, (j + s.y) / steps_.y);
    }
    return out;
}

} // namespace trivar
