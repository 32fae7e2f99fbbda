// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_counts.h"

#include "core/base/joined_sets.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Returns the length of a line in the middle of a chart, along u or along v.
double middle_length(const ChartSurface& surface, std::uint32_t chart, int axis)
{
    constexpr int pieces = 8;
    double length = 0;
    glm::dvec3 last(0);
    for (int k = 0; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        const glm::dvec3 p =
            surface.position({chart, axis == 0 ? glm::dvec2(t, 0.5) : glm::dvec2(0.5, t)});
        if (k > 0) length += glm::distance(p, last);
        last = p;
    }
    return length;
}

// `least`: of cells, where each chart has as few as it can.
void check_count(double cells, double least, std::size_t most)
{
    if (cells <= static_cast<double>(most)) return;
    const bool by_faces = !(least <= static_cast<double>(most));
    throw Rejected(fmt::format("it would take {} tiles to cover it; at most {} are laid, so {}",
                               number_text(cells), with_commas(most),
                               by_faces ? too_many_faces_words : "make them larger"));
}

} // namespace

std::vector<int> row_turns(const ChartNet& net)
{
    constexpr int unknown = -1;
    std::vector<int> turns(net.size(), unknown);
    for (std::uint32_t seed = 0; seed < net.size(); ++seed) {
        if (turns[seed] != unknown) continue;
        turns[seed] = 0;
        std::vector<std::uint32_t> queue{seed};
        for (std::size_t k = 0; k < queue.size(); ++k)
            for (int e = 0; e < 4; ++e) {
                const ChartNet::Side& other = net.across(queue[k], e);
                if (other.chart == ChartNet::none || turns[other.chart] != unknown) continue;
                turns[other.chart] = (turns[queue[k]] + other.edge - e + 2) & 3;
                queue.push_back(other.chart);
            }
    }
    return turns;
}

std::vector<glm::ivec2> cell_counts(const ChartSurface& surface, std::span<const int> turns,
                                    const glm::dvec2& size, bool even, std::size_t most)
{
    const ChartNet& net = surface.net();
    const auto charts = static_cast<std::uint32_t>(net.size());
    const auto side = [](std::uint32_t chart, int edge) {
        return 4 * chart + static_cast<std::uint32_t>(edge);
    };
    JoinedSets chords(4 * net.size());
    for (std::uint32_t c = 0; c < charts; ++c) {
        chords.join(side(c, 0), side(c, 2));
        chords.join(side(c, 1), side(c, 3));
        for (int e = 0; e < 4; ++e)
            if (const ChartNet::Side& other = net.across(c, e); other.chart != ChartNet::none)
                chords.join(side(c, e), side(other.chart, other.edge));
    }
    std::vector<double> sum(4 * net.size(), 0), weight(4 * net.size(), 0);
    for (std::uint32_t c = 0; c < charts; ++c)
        for (int axis = 0; axis < 2; ++axis) {
            const bool along_row = (turns[c] + axis) % 2 == 0;
            const std::uint32_t chord = chords.root(side(c, axis));
            sum[chord] += middle_length(surface, c, axis) / (along_row ? size.x : size.y);
            weight[chord] += 1;
        }
    const auto wanted = [&](std::uint32_t chart, int axis) {
        const std::uint32_t chord = chords.root(side(chart, axis));
        const double number = sum[chord] / weight[chord];
        if (!(number < 1e9)) return 1e9;
        return even ? std::max(2.0, 2 * std::round(number / 2)) : std::max(1.0, std::round(number));
    };
    double cells = 0;
    for (std::uint32_t c = 0; c < charts; ++c) cells += wanted(c, 0) * wanted(c, 1);
    check_count(cells, (even ? 4.0 : 1.0) * charts, most);
    std::vector<glm::ivec2> counts;
    for (std::uint32_t c = 0; c < charts; ++c) counts.emplace_back(wanted(c, 0), wanted(c, 1));
    return counts;
}

std::vector<glm::ivec2> cell_counts(const ChartNet& net, int per_edge, std::size_t most)
{
    const auto charts = static_cast<double>(net.size());
    check_count(charts * per_edge * per_edge, charts, most);
    return std::vector<glm::ivec2>(net.size(), glm::ivec2(per_edge));
}

} // namespace trivar
