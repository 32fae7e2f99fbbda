// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_scout.h"

#include "core/base/rejected.h"
#include "core/level/voxel_field.h"
#include "core/silhouette/silhouette_finder.h"
#include "core/voxels/coarsened.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace trivar {
namespace {

constexpr std::array scout_sights{glm::dvec3(1, 0.3, 0.2), glm::dvec3(-0.2, 1, 0.3),
                                  glm::dvec3(0.3, -0.2, 1)};
// The least length of lines on a plateau, as a share of the middle length of all values with lines.
// The greatest length tells nothing, since noise may have a hundred times that of a body.
constexpr double worth_a_look = 0.1;
constexpr double hardly_changes = 0.25;     // of itself, among the values beside it
constexpr std::size_t flat_beside = 2;      // values on each side, so that no peak counts as flat
constexpr std::size_t beside_a_plateau = 5; // values, among which just one is a plateau

double middle_of(std::vector<double> lengths)
{
    std::erase(lengths, 0.0);
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    return *middle;
}

double length_of(const Silhouettes& lines)
{
    double out = 0;
    for (std::size_t c = 0; c < lines.count(); ++c) {
        const std::uint32_t first = lines.first[c], end = lines.first[c + 1];
        for (std::uint32_t i = first + 1; i < end; ++i)
            out += double{glm::distance(lines.points[i].p, lines.points[i - 1].p)};
        if (lines.closed[c] && end > first)
            out += double{glm::distance(lines.points[first].p, lines.points[end - 1].p)};
    }
    return out;
}

std::vector<std::size_t> plateaus_of(const std::vector<double>& lengths)
{
    const std::size_t n = lengths.size();
    const double least = worth_a_look * middle_of(lengths);
    std::vector<double> change(n, 1e30);
    for (std::size_t i = flat_beside; i + flat_beside < n; ++i) {
        const auto [lo, hi] =
            std::ranges::minmax(std::span(lengths).subspan(i - flat_beside, 2 * flat_beside + 1));
        if (lengths[i] > least) change[i] = (hi - lo) / lengths[i];
    }
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < n; ++i) {
        bool is_least = change[i] < hardly_changes;
        const std::size_t from = i - std::min(i, beside_a_plateau),
                          to = std::min(n, i + beside_a_plateau + 1);
        for (std::size_t k = from; k < to; ++k)
            if (change[k] < change[i] || (change[k] == change[i] && k < i)) is_least = false;
        if (is_least) out.push_back(i);
    }
    return out;
}

} // namespace

LevelScout scout_levels(const VoxelGrid& grid, int levels, int most, const Progress& progress)
{
    if (levels < 3 || most < 2) throw Rejected("levels are scouted at 3 values or more");
    const glm::ivec3 block = (grid.size + most - 1) / most;
    const VoxelField field(make_ref(coarsened(grid, block)), {});
    const auto [least, greatest] = std::visit(
        [](const auto& samples) {
            const auto range = std::ranges::minmax(samples);
            return std::pair(static_cast<double>(range.min), static_cast<double>(range.max));
        },
        field.grid().samples);
    LevelScout out;
    SilhouetteFinder find;
    for (int i = 0; i < levels; ++i) {
        report(progress, static_cast<double>(i) / levels, "levels");
        const double value =
            grid.value(std::lerp(least, greatest, (static_cast<double>(i) + 0.5) / levels));
        const LevelMesh mesh = field.level(value, LevelAccuracy::quick);
        double length = 0;
        for (const glm::dvec3& sight : scout_sights)
            length += length_of(find(field.field(), mesh, {glm::dvec4(sight, 0)}));
        out.values.push_back(value);
        out.lengths.push_back(length / scout_sights.size());
    }
    if (grid.slope < 0) {
        std::ranges::reverse(out.values);
        std::ranges::reverse(out.lengths);
    }
    out.plateaus = plateaus_of(out.lengths);
    return out;
}

} // namespace trivar
