// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/pack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace trivar {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

// Counter-clockwise, by Andrew's monotone chain.
std::vector<glm::dvec2> hull_of(std::span<const glm::dvec2> points)
{
    std::vector<glm::dvec2> sorted(points.begin(), points.end()), hull;
    const auto key = [](const glm::dvec2& p) { return std::pair(p.x, p.y); };
    std::ranges::sort(sorted, {}, key);
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const glm::dvec2& p : sorted) {
            while (hull.size() > first + 1 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the other half begins with it
        std::ranges::reverse(sorted);
    }
    return hull;
}

// A ColumnRange is the extent of an outline in one column of a width, from its leftmost point on.
struct ColumnRange {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double y)
    {
        low = std::min(low, y);
        high = std::max(high, y);
    }
};
using Profile = std::vector<ColumnRange>;

struct Turned {
    glm::dmat2 turn{1};
    glm::dvec2 corner{0}; // lower left one of its box after the turn
    Profile profile;      // with its box at the origin
    double height = 0;
};

Turned turned(const std::vector<glm::dvec2>& outline, const glm::dmat2& turn, double column)
{
    Turned out{turn, glm::dvec2(std::numeric_limits<double>::infinity()), {}, 0};
    glm::dvec2 high(-out.corner);
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& p : outline) {
        points.push_back(turn * p);
        out.corner = glm::min(out.corner, points.back());
        high = glm::max(high, points.back());
    }
    out.height = high.y - out.corner.y;
    out.profile.resize(static_cast<std::size_t>((high.x - out.corner.x) / column) + 1);
    const auto column_of = [&](double x) {
        return std::min(static_cast<std::size_t>(x / column), out.profile.size() - 1);
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
        glm::dvec2 a = points[k] - out.corner, b = points[(k + 1) % points.size()] - out.corner;
        if (a.x > b.x) std::swap(a, b);
        const std::size_t first = column_of(a.x), last = column_of(b.x);
        const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
        for (std::size_t c = first; c <= last; ++c) { // at both sides of the column
            const double from = std::max(a.x, static_cast<double>(c) * column),
                         to = std::min(b.x, static_cast<double>(c + 1) * column);
            out.profile[c].add(c == first ? a.y : a.y + slope * (from - a.x));
            out.profile[c].add(c == last ? b.y : a.y + slope * (to - a.x));
        }
    }
    return out;
}

// A profile that keeps a distance on all sides. Its first column is `more` to the left.
Profile widened(const Profile& profile, double distance, std::size_t more)
{
    Profile out(profile.size() + 2 * more);
    for (std::size_t c = 0; c < profile.size(); ++c)
        for (std::size_t k = c; k <= c + 2 * more; ++k) {
            out[k].add(profile[c].low - distance);
            out[k].add(profile[c].high + distance);
        }
    return out;
}

struct Fall {
    std::size_t column = 0;
    double y = 0, top = std::numeric_limits<double>::infinity();
};

Fall lowest_fall(const std::vector<double>& sky, const Profile& profile, double height)
{
    Fall best;
    for (std::size_t at = 0; at + profile.size() <= sky.size(); ++at) {
        double y = 0;
        for (std::size_t c = 0; c < profile.size() && y + height < best.top; ++c)
            y = std::max(y, sky[at + c] - profile[c].low);
        if (y + height < best.top) best = {at, y, y + height};
    }
    return best;
}

// All outlines in a square; none if it is too small. `ways` are the turns of each that are tried.
std::optional<std::vector<PackedPlace>> packed_in(const std::vector<std::vector<Turned>>& ways,
                                                  std::span<const std::size_t> order, double column,
                                                  double side, double margin,
                                                  const Progress& progress)
{
    std::vector<double> sky(static_cast<std::size_t>(side / column), 0);
    const auto more = static_cast<std::size_t>(std::ceil(margin / column));
    std::vector<PackedPlace> out(ways.size());
    for (const std::size_t k : order) {
        report(progress, 0, "pack");
        Fall best;
        const Turned* chosen = nullptr;
        Profile its;
        for (const Turned& way : ways[k]) {
            Profile profile = widened(way.profile, margin, more);
            const Fall fall = lowest_fall(sky, profile, way.height + margin);
            if (fall.top >= best.top) continue;
            best = fall;
            chosen = &way;
            its = std::move(profile);
        }
        if (!chosen || best.top > side) return {};
        for (std::size_t c = 0; c < its.size(); ++c)
            sky[best.column + c] = std::max(sky[best.column + c], best.y + its[c].high);
        const double x = static_cast<double>(best.column + more) * column;
        out[k] = {chosen->turn, glm::dvec2(x, best.y) - chosen->corner};
    }
    return out;
}

} // namespace

glm::dmat2 smallest_box_turn(std::span<const glm::dvec2> points)
{
    const std::vector<glm::dvec2> hull = hull_of(points);
    glm::dmat2 best(1);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        const double length = glm::length(edge);
        if (!(length > 0)) continue;
        const glm::dvec2 x = edge / length, y(-x.y, x.x);
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
        for (const glm::dvec2& p : hull) {
            const glm::dvec2 q(glm::dot(p, x), glm::dot(p, y));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
        const glm::dvec2 size = high - low;
        if (size.x * size.y >= least) continue;
        least = size.x * size.y;
        best = size.x >= size.y ? glm::dmat2(x.x, y.x, x.y, y.y) : glm::dmat2(y.x, -x.x, y.y, -x.y);
    }
    return best;
}

Packing packed(std::span<const std::vector<glm::dvec2>> outlines, double margin,
               const Progress& progress)
{
    if (outlines.empty()) return {};
    double area = 0, widest = 0;
    std::vector<glm::dvec2> sizes;
    for (const std::vector<glm::dvec2>& outline : outlines) {
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
        double twice = 0;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            low = glm::min(low, outline[k]);
            high = glm::max(high, outline[k]);
            twice += cross(outline[k], outline[(k + 1) % outline.size()]);
        }
        sizes.push_back(high - low);
        area += std::abs(twice) / 2;
        widest = std::max(widest, std::min(sizes.back().x, sizes.back().y));
    }
    margin = std::min(margin, 0.25 / std::sqrt(static_cast<double>(sizes.size())));
    std::vector<std::size_t> order(sizes.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [&](std::size_t k) {
        const glm::dvec2 s = sizes[k];
        return std::tuple(-std::max(s.x, s.y), -std::min(s.x, s.y), k);
    });
    // Tries larger and larger squares, beginning with the least that could hold them.
    constexpr double larger = 1.02;
    double side = std::max(std::sqrt(area), widest) / (1 - 2 * margin);
    if (!(side > 0)) side = 1;
    constexpr int columns = 400;
    const double column = side / columns;
    // Lying, standing, and both
    const glm::dmat2 quarter(0, 1, -1, 0), half(-1, 0, 0, -1);
    std::vector<std::vector<Turned>> lying, standing, both;
    for (const std::vector<glm::dvec2>& outline : outlines) {
        report(progress, 0, "pack");
        const std::vector<glm::dmat2> flat{glm::dmat2(1), half}, up{quarter, half * quarter};
        for (const auto& [turns, to] : {std::pair(&flat, &lying), std::pair(&up, &standing)}) {
            to->emplace_back();
            for (const glm::dmat2& turn : *turns)
                to->back().push_back(turned(outline, turn, column));
        }
        both.push_back(lying.back());
        both.back().insert(both.back().end(), standing.back().begin(), standing.back().end());
    }
    for (;; side *= larger)
        for (const auto* ways : {&lying, &standing, &both})
            if (auto places = packed_in(*ways, order, column, side, margin * side, progress))
                return {std::move(*places), side, margin};
}

} // namespace trivar
