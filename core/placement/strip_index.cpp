// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_index.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr double buckets_a_quad = 1.5; // along each axis

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

// Returns the barycentric coordinates of q in a triangle with the right angle of its parameters at
// a: the shares of b and c. None outside, or for a triangle without area.
std::optional<glm::dvec2> shares(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 q)
{
    constexpr double slack = 1e-6; // a pixel on a common edge is in both triangles
    const glm::dvec2 ab = b - a, ac = c - a, aq = q - a;
    const double area = cross(ab, ac), of_b = cross(aq, ac), of_c = cross(ab, aq);
    const double least = area < 0 ? -std::max({of_b, of_c, area - of_b - of_c})
                                  : std::min({of_b, of_c, area - of_b - of_c});
    if (area == 0 || least < -slack * std::abs(area)) return {};
    return glm::dvec2(of_b, of_c) / area;
}

// Computes the bend of a grid of points on the surface from second differences: their part along
// the normal, because points unevenly spaced on a slope are no bend.
std::vector<StripIndex::Bend> bends(const std::vector<glm::dvec3>& points,
                                    const std::vector<glm::dvec2>& points_px, glm::ivec2 steps,
                                    double quad_px, const View& view)
{
    std::vector<StripIndex::Bend> out(points.size());
    const auto columns = static_cast<std::size_t>(steps.y) + 1;
    const double shortest = 0.01 * quad_px * quad_px; // of a squared step that is seen edge-on
    parallel_blocks(
        static_cast<std::size_t>(steps.x) + 1, 16, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                for (std::size_t j = 0; j < columns; ++j) {
                    // At the rim the bend of the next inner points is used.
                    const std::size_t ii =
                        std::clamp<std::size_t>(i, 1, static_cast<std::size_t>(steps.x) - 1);
                    const std::size_t k = ii * columns + std::clamp<std::size_t>(j, 1, columns - 2);
                    const glm::dvec3 u = (points[k + columns] - points[k - columns]) / 2.0;
                    const glm::dvec3 v = (points[k + 1] - points[k - 1]) / 2.0;
                    const glm::dvec3 n = glm::cross(u, v), toward = view.toward_eye(points[k]);
                    const double along = glm::dot(n, toward), least = 0.02 * glm::length(n);
                    const double facing =
                        along < 0 ? std::min(along, -least) : std::max(along, least);
                    if (facing == 0) continue;
                    const auto along_axis = [&](std::size_t step) {
                        const glm::dvec3 off =
                            points[k - step] + points[k + step] - 2.0 * points[k];
                        return glm::dot(off, n) / facing;
                    };
                    const glm::dvec3 twist = points[k + columns + 1] - points[k + columns - 1] -
                                             points[k - columns + 1] + points[k - columns - 1];
                    const double mixed = glm::dot(twist, n) / facing / 4;
                    const auto px2 = [&](std::size_t step) {
                        const glm::dvec2 d = (points_px[k + step] - points_px[k - step]) / 2.0;
                        return std::max(glm::dot(d, d), shortest);
                    };
                    out[i * columns + j] = {{along_axis(columns), along_axis(1)},
                                            {mixed, mixed},
                                            {px2(columns), px2(1)}};
                }
        });
    return out;
}

} // namespace

// A SeenQuad is a quad in the picture: its place in the parameters, its middle, and the areas of
// its halves.
struct StripIndex::SeenQuad {
    glm::ivec2 at{0};
    glm::dvec2 middle_px{0};
    double least = 0, most = 0;

    SeenQuad() = default;
    SeenQuad(const StripIndex& s, std::size_t first_corner)
    {
        const auto columns = static_cast<std::size_t>(s.steps_.y) + 1;
        at = {first_corner / columns, first_corner % columns};
        if (at.x == s.steps_.x || at.y == s.steps_.y) return;
        const glm::dvec2* corner = s.corners_px_.data() + first_corner;
        const glm::dvec2* next = corner + columns;
        const double a = cross(next[0] - corner[0], corner[1] - corner[0]),
                     b = cross(corner[1] - next[1], next[0] - next[1]);
        middle_px = (corner[0] + corner[1] + next[0] + next[1]) / 4.0;
        least = std::min(a, b);
        most = std::max(a, b);
    }
};

StripIndex::StripIndex(const SurfaceTable& surface, const View& view, glm::ivec2 steps)
    : steps_(steps),
      lo_(1e300),
      hi_(-1e300)
{
    const std::vector<glm::dvec3> corners = surface.grid(steps);
    corners_px_.reserve(corners.size());
    for (const glm::dvec3& corner : corners) corners_px_.push_back(view.project(corner).p_px);
    const std::vector<glm::dvec2> seen_px = corners_px_;
    widen_rim();
    const auto quad = [&](int i, int j) {
        const int a = i * (steps.y + 1) + j;
        return std::array{a, a + 1, a + steps.y + 1, a + steps.y + 2};
    };
    double area = 0;
    for (int i = 0; i < steps.x; ++i)
        for (int j = 0; j < steps.y; ++j) {
            for (const int k : quad(i, j)) {
                lo_ = glm::min(lo_, corners_px_[static_cast<std::size_t>(k)]);
                hi_ = glm::max(hi_, corners_px_[static_cast<std::size_t>(k)]);
            }
            const glm::dvec2* corner = corners_px_.data() + i * (steps.y + 1) + j;
            area +=
                std::abs(cross(corner[steps.y + 2] - corner[0], corner[steps.y + 1] - corner[1])) /
                2;
        }
    const double count = static_cast<double>(steps.x) * steps.y;
    // If a strip is seen edge-on, its quads have no area but still a size.
    const glm::dvec2 size = glm::max(hi_ - lo_, glm::dvec2(1e-9));
    quad_px_ = std::max(std::sqrt(area / count), 0.01 * glm::length(size) / std::sqrt(count));
    buckets_ =
        glm::clamp(glm::ivec2(buckets_a_quad * size / quad_px_), glm::ivec2(1), glm::ivec2(1024));
    buckets_per_px_ = glm::dvec2(buckets_) / size;

    struct BucketRange {
        glm::ivec2 from{0}, to{-1};
    };
    std::vector<BucketRange> touched(corners.size()); // of each quad, in buckets
    parallel_blocks(static_cast<std::size_t>(steps.x), 16, [&](std::size_t begin, std::size_t end) {
        const glm::ivec2 most = buckets_ - 1;
        for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
            for (int j = 0; j < steps.y; ++j) {
                glm::dvec2 lo(1e300), hi(-1e300);
                for (const int k : quad(i, j)) {
                    lo = glm::min(lo, corners_px_[static_cast<std::size_t>(k)]);
                    hi = glm::max(hi, corners_px_[static_cast<std::size_t>(k)]);
                }
                BucketRange& r = touched[static_cast<std::size_t>(quad(i, j)[0])];
                r.from = glm::clamp(glm::ivec2((lo - lo_) * buckets_per_px_), glm::ivec2(0), most);
                r.to = glm::clamp(glm::ivec2((hi - lo_) * buckets_per_px_), glm::ivec2(0), most);
            }
    });
    // The first pass counts the quads of each bucket, the second one writes them.
    const auto each = [&](const auto& visit) {
        for (std::size_t k = 0; k < touched.size(); ++k)
            for (int y = touched[k].from.y; y <= touched[k].to.y; ++y)
                for (int x = touched[k].from.x; x <= touched[k].to.x; ++x)
                    visit(static_cast<std::size_t>(y * buckets_.x + x), static_cast<int>(k));
    };
    begin_.assign(static_cast<std::size_t>(buckets_.x * buckets_.y) + 1, 0);
    each([&](std::size_t b, int) { ++begin_[b + 1]; });
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    quads_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    each([&](std::size_t b, int corner) { quads_[static_cast<std::size_t>(next[b]++)] = corner; });
    const std::vector<Bend> at_corners = bends(corners, seen_px, steps, quad_px_, view);
    bend_.resize(corners.size());
    std::vector<SeenQuad> seen(corners_px_.size());
    parallel_blocks(static_cast<std::size_t>(steps.x), 16, [&](std::size_t begin, std::size_t end) {
        for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
            for (int j = 0; j < steps.y; ++j) {
                const auto first = static_cast<std::size_t>(quad(i, j)[0]);
                for (const int k : quad(i, j))
                    bend_[first].add(at_corners[static_cast<std::size_t>(k)]);
                seen[first] = SeenQuad(*this, first);
            }
    });
    for (const Bend& bend : bend_) most_bend_.add(bend);
    plain_.resize(begin_.size() - 1);
    parallel_blocks(plain_.size(), 1024, [&](std::size_t from, std::size_t to) {
        for (std::size_t b = from; b < to; ++b) plain_[b] = plain_quad(b, seen);
    });
}

// Returns the quad of a bucket nearest to its middle if no quads there can overlap: they are few,
// of similar size, neighbours in the parameters and seen from the same side. -1 if they may
// overlap.
int StripIndex::plain_quad(std::size_t bucket, const std::vector<SeenQuad>& quads) const
{
    constexpr int widest = 6;           // along each axis of the parameters
    constexpr double most_uneven = 0.1; // smallest over largest area
    const auto x = static_cast<int>(bucket) % buckets_.x, y = static_cast<int>(bucket) / buckets_.x;
    const glm::dvec2 middle = lo_ + (glm::dvec2(x, y) + 0.5) / buckets_per_px_;
    glm::ivec2 first(steps_), last(0);
    double least = 1e300, most = -1e300, nearest = 1e300;
    int out = -1;
    for (int e = begin_[bucket]; e < begin_[bucket + 1]; ++e) {
        const int corner = quads_[static_cast<std::size_t>(e)];
        const SeenQuad& quad = quads[static_cast<std::size_t>(corner)];
        first = glm::min(first, quad.at);
        last = glm::max(last, quad.at);
        least = std::min(least, quad.least);
        most = std::max(most, quad.most);
        const glm::dvec2 off = quad.middle_px - middle;
        if (glm::dot(off, off) < nearest) {
            nearest = glm::dot(off, off);
            out = corner;
        }
    }
    const bool alike = least > most_uneven * most || most < most_uneven * least;
    const bool few = last.x - first.x < widest && last.y - first.y < widest;
    return few && alike ? out : -1;
}

// Returns the parameters at a pixel by the affine map at the middle of the quad.
glm::dvec2 StripIndex::along_quad(int first_corner, glm::dvec2 p_px) const
{
    const glm::dvec2* corner = corners_px_.data() + first_corner;
    const glm::dvec2* next = corner + steps_.y + 1;
    const glm::dvec2 u = (next[0] + next[1] - corner[0] - corner[1]) / 2.0;
    const glm::dvec2 v = (corner[1] + next[1] - corner[0] - next[0]) / 2.0;
    const glm::dvec2 q = p_px - (corner[0] + corner[1] + next[0] + next[1]) / 4.0;
    const double area = cross(u, v);
    const int i = first_corner / (steps_.y + 1), j = first_corner % (steps_.y + 1);
    const glm::dvec2 at(i + 0.5 + cross(q, v) / area, j + 0.5 + cross(u, q) / area);
    return glm::clamp(at / glm::dvec2(steps_), 0.0, 1.0);
}

StripIndex::Surroundings::Surroundings(const StripIndex& strip, double px)
    : strip_(strip),
      px_(px),
      near_(strip.begin_.size(), 0)
{
    const glm::ivec2 size = strip.buckets_;
    const glm::ivec2 reach = glm::ivec2(px * strip.buckets_per_px_) + 1;
    std::vector<char> near(near_.size() - 1, 0), wide(near.size(), 0);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
    // The rectangle round each bucket is marked along x first, then along y.
    for (int y = 0; y < size.y; ++y)
        for (int x = 0, until = -1; x < size.x + reach.x; ++x) {
            if (x < size.x && strip.begin_[at(x, y)] < strip.begin_[at(x, y) + 1])
                until = x + 2 * reach.x;
            if (x >= reach.x) wide[at(x - reach.x, y)] = x <= until;
        }
    for (int x = 0; x < size.x; ++x)
        for (int y = 0, until = -1; y < size.y + reach.y; ++y) {
            if (y < size.y && wide[at(x, y)]) until = y + 2 * reach.y;
            if (y >= reach.y) near[at(x, y - reach.y)] = y <= until;
        }
    for (std::size_t b = 0; b < near.size(); ++b) near_[b + 1] = near_[b] + near[b];
}

bool StripIndex::Surroundings::may_touch(glm::dvec2 lo_px, glm::dvec2 hi_px) const
{
    if (!glm::all(glm::lessThanEqual(lo_px, strip_.hi_ + px_)) ||
        !glm::all(glm::greaterThanEqual(hi_px, strip_.lo_ - px_)))
        return false;
    return strip_.meets(near_, glm::clamp(lo_px, strip_.lo_, strip_.hi_),
                        glm::clamp(hi_px, strip_.lo_, strip_.hi_));
}

// Widens the quads along the rim, which is curved while their sides are straight, so that no part
// of the strip is missed. The caller finds the true rim in the parameters.
void StripIndex::widen_rim()
{
    constexpr double share = 0.15; // relative to a quad
    const auto rows = static_cast<std::size_t>(steps_.x) + 1;
    const auto columns = static_cast<std::size_t>(steps_.y) + 1;
    const auto widen = [&](std::size_t rim, std::size_t inside) {
        corners_px_[rim] += share * (corners_px_[rim] - corners_px_[inside]);
    };
    for (std::size_t j = 0; j < columns; ++j) {
        widen(j, j + columns);
        widen((rows - 1) * columns + j, (rows - 2) * columns + j);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        widen(i * columns, i * columns + 1);
        widen(i * columns + columns - 1, i * columns + columns - 2);
    }
}

std::size_t StripIndex::bucket(glm::dvec2 p_px) const
{
    const glm::ivec2 at =
        glm::clamp(glm::ivec2((p_px - lo_) * buckets_per_px_), glm::ivec2(0), buckets_ - 1);
    return static_cast<std::size_t>(at.y * buckets_.x + at.x);
}

StripIndex::Bend StripIndex::bend(glm::dvec2 lo, glm::dvec2 hi) const
{
    constexpr int few = 4; // quads along an axis: more are not examined one by one
    const glm::ivec2 last = steps_ - 1;
    const glm::ivec2 from = glm::clamp(glm::ivec2(lo * glm::dvec2(steps_)), glm::ivec2(0), last);
    const glm::ivec2 to = glm::clamp(glm::ivec2(hi * glm::dvec2(steps_)), glm::ivec2(0), last);
    if (to.x - from.x >= few || to.y - from.y >= few) return most_bend_;
    Bend out;
    for (int i = from.x; i <= to.x; ++i)
        for (int j = from.y; j <= to.y; ++j)
            out.add(bend_[static_cast<std::size_t>(i * (steps_.y + 1) + j)]);
    return out;
}

bool StripIndex::may_cover(glm::dvec2 p_px) const
{
    if (!(p_px.x >= lo_.x && p_px.y >= lo_.y && p_px.x <= hi_.x && p_px.y <= hi_.y)) return false;
    const std::size_t b = bucket(p_px);
    return begin_[b] < begin_[b + 1];
}

void StripIndex::mark_changed(const std::vector<char>& corners)
{
    const int columns = steps_.y + 1;
    // A bend changes one corner further.
    const auto near_change = [&](int i, int j) {
        for (int a = std::max(i - 1, 0); a <= std::min(i + 2, steps_.x); ++a)
            for (int b = std::max(j - 1, 0); b <= std::min(j + 2, steps_.y); ++b)
                if (corners[static_cast<std::size_t>(a * columns + b)]) return true;
        return false;
    };
    std::vector<char> quad(corners.size(), 0);
    for (int i = 0; i < steps_.x; ++i)
        for (int j = 0; j < steps_.y; ++j)
            quad[static_cast<std::size_t>(i * columns + j)] = near_change(i, j);
    changed_.assign(begin_.size(), 0);
    changed_lo_ = glm::dvec2(1e300);
    changed_hi_ = glm::dvec2(-1e300);
    for (std::size_t b = 0; b + 1 < begin_.size(); ++b) {
        bool any = false;
        for (int e = begin_[b]; e < begin_[b + 1]; ++e)
            any = any || quad[static_cast<std::size_t>(quads_[static_cast<std::size_t>(e)])];
        changed_[b + 1] = changed_[b] + any;
        if (!any) continue;
        const auto x = static_cast<int>(b) % buckets_.x, y = static_cast<int>(b) / buckets_.x;
        // One more bucket is included because of rounding.
        changed_lo_ = glm::min(changed_lo_, lo_ + glm::dvec2(x - 1, y - 1) / buckets_per_px_);
        changed_hi_ = glm::max(changed_hi_, lo_ + glm::dvec2(x + 2, y + 2) / buckets_per_px_);
    }
}

// Says whether any is in the rectangle, where `before` counts them in the buckets before each one.
bool StripIndex::meets(const std::vector<int>& before, glm::dvec2 lo_px, glm::dvec2 hi_px) const
{
    if (!glm::all(glm::lessThanEqual(lo_px, hi_)) || !glm::all(glm::greaterThanEqual(hi_px, lo_)))
        return false;
    const glm::ivec2 most = buckets_ - 1;
    const glm::dvec2 lo = (glm::max(lo_px, lo_) - lo_) * buckets_per_px_;
    const glm::dvec2 hi = (glm::min(hi_px, hi_) - lo_) * buckets_per_px_;
    const glm::ivec2 from = glm::min(glm::ivec2(lo), most), to = glm::min(glm::ivec2(hi), most);
    for (int y = from.y; y <= to.y; ++y) {
        const auto row = static_cast<std::size_t>(y * buckets_.x);
        if (before[row + static_cast<std::size_t>(from.x)] <
            before[row + static_cast<std::size_t>(to.x) + 1])
            return true;
    }
    return false;
}

std::optional<glm::dvec2> StripIndex::in_quad(int first_corner, glm::dvec2 p_px) const
{
    const glm::dvec2* corner = corners_px_.data() + first_corner;
    const glm::dvec2* next = corner + steps_.y + 1;
    // Most quads of a bucket are excluded by their boxes.
    const glm::dvec2 lo = glm::min(glm::min(corner[0], corner[1]), glm::min(next[0], next[1]));
    const glm::dvec2 hi = glm::max(glm::max(corner[0], corner[1]), glm::max(next[0], next[1]));
    if (p_px.x < lo.x || p_px.y < lo.y || p_px.x > hi.x || p_px.y > hi.y) return {};
    auto s = shares(corner[0], next[0], corner[1], p_px);
    if (!s) {
        s = shares(next[1], corner[1], next[0], p_px);
        if (!s) return {};
        s = 1.0 - *s;
    }
    const int i = first_corner / (steps_.y + 1), j = first_corner % (steps_.y + 1);
    return (glm::dvec2(i, j) + *s) / glm::dvec2(steps_);
}

} // namespace trivar
