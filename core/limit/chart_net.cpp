// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/chart_net.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int most_edges_crossed = 256;

// Returns how far out of the chart a place lies, beyond an edge.
double beyond_edge(int edge, const glm::dvec2& uv)
{
    switch (edge) {
    case 0: return -uv.y;
    case 1: return uv.x - 1;
    case 2: return uv.y - 1;
    default: return -uv.x;
    }
}

// Where along an edge a place lies.
double share_of_edge(int edge, const glm::dvec2& uv)
{
    switch (edge) {
    case 0: return uv.x;
    case 1: return uv.y;
    case 2: return 1 - uv.x;
    default: return 1 - uv.y;
    }
}

struct CageSide {
    int low, high; // its points
    std::uint32_t chart;
    int edge;
    bool upward;
};

} // namespace

glm::dvec2 chart_corner(int corner)
{
    static constexpr std::array<glm::dvec2, 4> all{glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}};
    return all[static_cast<std::size_t>(corner & 3)];
}

glm::dvec2 along_edge(int edge)
{
    return quarter_turned({1, 0}, edge);
}

glm::dvec2 out_of_edge(int edge)
{
    return quarter_turned({0, -1}, edge);
}

glm::dvec2 on_edge(int edge, double t)
{
    switch (edge) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {1 - t, 1};
    default: return {0, 1 - t};
    }
}

glm::dvec2 quarter_turned(const glm::dvec2& v, int turns)
{
    switch (turns & 3) {
    case 1: return {-v.y, v.x};
    case 2: return {-v.x, -v.y};
    case 3: return {v.y, -v.x};
    default: return v;
    }
}

ChartNet::ChartNet(std::span<const int> corners, std::span<const int> crease_ends)
    : charts_(corners.size() / 4)
{
    std::vector<CageSide> sides;
    for (std::size_t c = 0; c < charts_.size(); ++c)
        for (std::size_t e = 0; e < 4; ++e) {
            const int a = corners[4 * c + e], b = corners[4 * c + (e + 1) % 4];
            charts_[c].points[e] = static_cast<std::uint32_t>(a);
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(c),
                             static_cast<int>(e), a < b});
        }
    const auto ends = [](const CageSide& s) { return std::pair(s.low, s.high); };
    std::ranges::stable_sort(sides, {}, ends);
    std::vector<std::pair<int, int>> creases;
    for (std::size_t i = 0; i + 1 < crease_ends.size(); i += 2)
        creases.emplace_back(std::minmax(crease_ends[i], crease_ends[i + 1]));
    std::ranges::sort(creases);
    for (auto first = sides.begin(); first != sides.end();) {
        auto last = first;
        while (last != sides.end() && ends(*last) == ends(*first)) ++last;
        if (std::ranges::binary_search(creases, ends(*first)))
            for (auto each = first; each != last; ++each)
                charts_[each->chart].crease[static_cast<std::size_t>(each->edge)] = true;
        if (last - first == 2 && first->low != first->high && first->upward != first[1].upward) {
            charts_[first->chart].across[static_cast<std::size_t>(first->edge)] = {first[1].chart,
                                                                                   first[1].edge};
            charts_[first[1].chart].across[static_cast<std::size_t>(first[1].edge)] = {first->chart,
                                                                                       first->edge};
        }
        first = last;
    }
}

ChartPlace ChartNet::beyond(const ChartPlace& at, int edge) const
{
    const Side& other = across(at.chart, edge);
    return {other.chart, on_edge(other.edge, 1 - share_of_edge(edge, at.uv))};
}

ChartNet::Walk ChartNet::walk(const ChartPlace& from, const glm::dvec2& step,
                              bool over_creases) const
{
    Walk w{from, step, 1};
    for (int crossed = 0; crossed < most_edges_crossed; ++crossed) {
        double nearest = w.left;
        int out = -1;
        for (int e = 0; e < 4; ++e) {
            const double speed = glm::dot(w.step, out_of_edge(e));
            if (!(speed > 0)) continue;
            const double to_edge = std::max(0.0, -beyond_edge(e, w.at.uv) / speed);
            if (to_edge < nearest) nearest = to_edge, out = e;
        }
        w.at.uv += nearest * w.step;
        w.left -= nearest;
        if (out < 0) {
            w.left = 0;
            return w;
        }
        w.at.uv = on_edge(out, std::clamp(share_of_edge(out, w.at.uv), 0.0, 1.0));
        const Side& other = across(w.at.chart, out);
        if (other.chart == none || (!over_creases && is_crease(w.at.chart, out))) {
            w.edge = out;
            return w;
        }
        w.at = beyond(w.at, out);
        const int turned = other.edge - out + 2;
        w.step = quarter_turned(w.step, turned);
        w.turns += turned;
    }
    return w;
}

} // namespace trivar
