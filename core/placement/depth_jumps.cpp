// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/depth_jumps.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/placement/creases.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// The least jump, as a share of the length that the stroke would have across the view.
constexpr double least_jump = 0.15;
constexpr double over_width = 0.6;   // share of that which counts over the width
constexpr double longest_end = 0.15; // share of the way that may overshoot an edge
constexpr double far_behind = 0.5;   // of the way: a step that is less high is followed
constexpr int halvings = 12;         // a steep surface keeps less than a thousandth of its step

} // namespace

std::vector<std::size_t> DepthJumps::taken(RayGrid& grid, const std::vector<Seen>& line)
{
    std::vector<std::size_t> out;
    for (const Seen& each : line)
        if (each.beyond) {
            grid.distance[each.node] = each.distance;
            out.push_back(each.node);
        }
    return out;
}

bool DepthJumps::jumps(Seen a, Seen b, double least) const
{
    for (int i = 0; i < halvings; ++i) {
        Seen middle{(a.p_px + b.p_px) / 2.0, 0, 0, false};
        const auto hit = scene_.hit(view_.ray(middle.p_px), 0, 1e300, skip_back_faces_);
        if (!hit) return true;
        middle.distance = hit->distance;
        const bool first =
            std::abs(middle.distance - a.distance) > std::abs(middle.distance - b.distance);
        (first ? b : a) = middle;
    }
    return std::abs(a.distance - b.distance) > least / 2;
}

std::vector<std::pair<std::size_t, double>> DepthJumps::follow(std::vector<Seen>& line,
                                                               double least) const
{
    std::vector<std::pair<std::size_t, double>> out;
    std::size_t on = 0, before = 0; // the last two places on the surface
    for (std::size_t i = 1; i < line.size(); ++i) {
        const bool beyond = line[i - 1].beyond;
        const double gap_px = glm::distance(line[i].p_px, line[on].p_px);
        const double depth = line[i].distance - line[on].distance;
        // Beyond a gap the surface goes on where the way over it is no steeper than it is wide.
        const double gap = beyond ? gap_px * view_.pixel_size(line[on].distance) : 0;
        const bool jump =
            std::abs(depth) >= least + gap && (beyond || jumps(line[on], line[i], least));
        if (jump && (!beyond || depth < 0)) out.emplace_back(i, depth);
        if (jump && depth > 0) out.back().second = std::max(out.back().second, depth);
        line[i].beyond = jump && depth > 0;
        if (line[i].beyond) continue;
        for (std::size_t k = on + 1; k < i; ++k) // a line of space is one of inverse distances
            line[k].distance = 1 / glm::mix(1 / line[on].distance, 1 / line[i].distance,
                                            glm::distance(line[k].p_px, line[on].p_px) / gap_px);
        before = on;
        on = i;
    }
    const double last = line[on].distance;
    const double way_px = glm::distance(line[before].p_px, line[on].p_px);
    for (std::size_t k = on + 1; k < line.size(); ++k) {
        const double gone_px = glm::distance(line[k].p_px, line[on].p_px);
        const double share = way_px > 0 ? gone_px / way_px : 0;
        const double inverse = 1 / last + share * (1 / last - 1 / line[before].distance);
        // A surface that is seen from the side at its edge goes on no steeper than it is wide.
        const double most = std::min(least, gone_px * view_.pixel_size(last));
        line[k].distance = std::clamp(inverse > 0 ? 1 / inverse : 1e300, last - most, last + most);
    }
    return out;
}

std::optional<std::vector<std::size_t>> DepthJumps::bridge(RayGrid& line,
                                                           const std::vector<glm::dvec2>& points_px)
{
    std::vector<Seen> seen;
    std::vector<double> walked{0}, distances;
    for (std::size_t k = 0; k < points_px.size(); ++k) {
        if (k > 0) walked.push_back(walked[k - 1] + glm::distance(points_px[k - 1], points_px[k]));
        if (!line.hit[k]) continue;
        seen.push_back({points_px[k], line.distance[k], k});
        distances.push_back(line.distance[k]);
    }
    const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, median);
    const double way = walked.back() * view_.pixel_size(*median); // metres across the view
    least_ = least_jump * way;
    const auto at = [&](std::size_t i) { return walked[seen[i].node] / walked.back(); };
    found_.clear();
    std::size_t first = 0; // on the surface before all others
    double highest = 0;    // of the steps, metres over the surface behind
    for (const auto& [i, depth] : follow(seen, least_)) {
        found_.push_back({at(i), depth});
        if (depth < 0) first = i;
        const std::size_t behind = seen[depth > 0 ? i : i - 1].node;
        highest = std::max(
            highest, std::abs(depth * glm::dot(line.normal[behind], line.rays[behind].direction)));
    }
    of_line_ = found_.size();
    std::size_t last = seen.size() - 1;
    while (seen[last].beyond) --last;
    // Jumps at parts that it passes in the air do not count
    if (at(first) - at(0) > longest_end || at(seen.size() - 1) - at(last) > longest_end) {
        if (highest < far_behind * way) {
            found_.clear();
            of_line_ = 0;
            return {};
        }
        throw Rejected(fmt::format(
            "{} along the stroke it jumps {} m in depth, from one surface to another; draw it on "
            "one of them, or look from where the way between them is seen",
            percent_text(deepest(found_).at),
            number_text(std::abs(deepest(found_).depth), {.digits = 2})));
    }
    std::vector<Seen> begin(seen.rend() - static_cast<std::ptrdiff_t>(first) - 1, seen.rend());
    follow(begin, least_);
    std::ranges::reverse_copy(begin, seen.begin());
    return taken(line, seen);
}

std::vector<std::size_t> DepthJumps::bridge(RayGrid& grid, const Strip& strip, const RayGrid& line)
{
    found_.resize(of_line_);
    const int half = grid.columns / 2;
    std::vector<std::size_t> out;
    for (int i = 0; i < grid.rows; ++i) {
        const double a = grid.a[static_cast<std::size_t>(i)];
        const Strip::Ruling across = strip.ruling(a);
        const Bracket at = bracket(line.a, a);
        const auto k = static_cast<std::size_t>(at.first);
        for (const int way : {1, -1}) {
            std::vector<Seen> seen{
                {across.at(0.5), glm::mix(line.distance[k], line.distance[k + 1], at.share), 0}};
            for (int j = way > 0 ? half : half - 1; j >= 0 && j < grid.columns; j += way)
                if (const std::size_t n = grid.index(i, j); grid.hit[n])
                    seen.push_back({across.at(grid.v[n]), grid.distance[n], n});
            for (const auto& jump : follow(seen, over_width * least_))
                found_.push_back({a, jump.second});
            const std::vector<std::size_t> beyond = taken(grid, seen);
            out.insert(out.end(), beyond.begin(), beyond.end());
        }
    }
    return out;
}

} // namespace trivar
