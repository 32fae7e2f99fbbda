// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/line_budget.h"

#include "core/base/key_numbers.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float kept_bonus = 1.25f;
constexpr float least_steepness = 0.25f, most_steepness = 4; // relative to the median

float median_slope(std::span<const Stroke> strokes)
{
    std::vector<float> slopes;
    for (const Stroke& stroke : strokes)
        for (const StrokePoint& p : stroke.points) slopes.push_back(p.slope);
    if (slopes.empty()) return 0;
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::ranges::nth_element(slopes, middle);
    return *middle;
}

double importance(const Stroke& stroke, float median)
{
    double out = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
        const StrokePoint& p = stroke.points[i];
        const float steep =
            median > 0 ? std::clamp(p.slope / median, least_steepness, most_steepness) : 1;
        out += double{glm::distance(stroke.points[i - 1].at, p.at)} *
               double{std::sqrt(steep) * p.strength};
    }
    return out;
}

// NearCells marks the cells of an image that have a point of a drawing, with sides as long as the
// reach.
class NearCells {
public:
    NearCells(std::span<const Stroke> strokes, float reach) : reach_(reach)
    {
        for (const Stroke& stroke : strokes)
            for (const StrokePoint& p : stroke.points) {
                const auto [number, is_new] = cells_.number(key(cell(p.at)));
                if (is_new) points_.emplace_back();
                points_[number].push_back(p.at);
            }
    }
    bool has_near(const glm::vec2& at) const
    {
        const glm::ivec2 own = cell(at);
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (const std::uint32_t n = cells_.find(key(own + glm::ivec2(x, y)));
                    n != KeyNumbers::none &&
                    std::ranges::any_of(points_[n], [&](const glm::vec2& p) {
                        return glm::distance(p, at) <= reach_;
                    }))
                    return true;
        return false;
    }

private:
    glm::ivec2 cell(const glm::vec2& at) const { return glm::ivec2(glm::floor(at / reach_)); }
    static std::uint64_t key(const glm::ivec2& c)
    {
        return pair_key(static_cast<std::uint32_t>(c.x), static_cast<std::uint32_t>(c.y));
    }

    float reach_;
    KeyNumbers cells_;
    std::vector<std::vector<glm::vec2>> points_;
};

} // namespace

std::vector<float> persistence(std::span<const Stroke> strokes,
                               std::span<const std::vector<Stroke>> nearby, float reach_px)
{
    std::vector<float> out(strokes.size(), nearby.empty() ? 1.0f : 0.0f);
    for (const std::vector<Stroke>& other : nearby) {
        const NearCells cells(other, reach_px);
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const std::vector<StrokePoint>& points = strokes[i].points;
            const auto near = std::ranges::count_if(
                points, [&](const StrokePoint& p) { return cells.has_near(p.at); });
            out[i] += static_cast<float>(near) /
                      static_cast<float>(std::max<std::size_t>(1, points.size()) * nearby.size());
        }
    }
    return out;
}

std::vector<Stroke> within_budget(std::vector<Stroke> strokes, float share,
                                  std::span<const float> weights,
                                  std::span<const std::uint64_t> kept_before)
{
    if (share >= 1) return strokes;
    const float median = median_slope(strokes);
    KeyNumbers before(kept_before.size());
    for (const std::uint64_t edge : kept_before) before.number(edge);
    std::vector<double> scores;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        double score = importance(strokes[i], median);
        if (i < weights.size()) score *= double{weights[i]};
        if (before.contains(strokes[i].id)) score *= double{kept_bonus};
        scores.push_back(score);
        order.push_back(i);
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return scores[a] != scores[b] ? scores[a] > scores[b] : strokes[a].id < strokes[b].id;
    });
    std::vector<char> stays(strokes.size(), 0);
    for (const bool hidden : {false, true}) {
        double all = 0, taken = 0;
        for (const Stroke& stroke : strokes)
            if (stroke.hidden == hidden) all += stroke.length();
        for (const std::size_t i : order) {
            if (strokes[i].hidden != hidden) continue;
            if (taken >= double{share} * all) break;
            taken += strokes[i].length();
            stays[i] = 1;
        }
    }
    std::vector<Stroke> out;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (stays[i]) out.push_back(std::move(strokes[i]));
    return out;
}

} // namespace trivar
