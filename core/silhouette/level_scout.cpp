// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/level_scout.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/silhouette_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr std::array scout_sights{glm::dvec3(1, 0.3, 0.2), glm::dvec3(-0.2, 1, 0.3),
                                  glm::dvec3(0.3, -0.2, 1)};
constexpr double worth_a_look = 0.05;       // of the greatest length: less is no plateau
constexpr double hardly_changes = 0.15;     // of itself, from the value before to the one after
constexpr std::size_t beside_a_plateau = 3; // values, among which just one is a plateau

// Data averaged over blocks of samples.
struct CoarseGrid {
    glm::ivec3 size;
    std::vector<float> samples;
};

template <class Sample>
CoarseGrid coarse(const std::vector<Sample>& samples, const glm::ivec3& size, int most)
{
    const glm::ivec3 block = glm::max(glm::ivec3(1), (size + most - 1) / most);
    CoarseGrid out{glm::max(glm::ivec3(2), size / block), {}};
    out.samples.resize(static_cast<std::size_t>(out.size.x) * static_cast<std::size_t>(out.size.y) *
                       static_cast<std::size_t>(out.size.z));
    const auto row = static_cast<std::size_t>(out.size.x);
    parallel_blocks(out.samples.size() / row, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            for (std::size_t i = 0; i < row; ++i) {
                const auto height = static_cast<std::size_t>(out.size.y);
                const glm::ivec3 at(static_cast<int>(i), static_cast<int>(r % height),
                                    static_cast<int>(r / height));
                const glm::ivec3 lo = glm::min(at * block, size - 1),
                                 hi = glm::min(lo + block, size);
                double sum = 0;
                for (int z = lo.z; z < hi.z; ++z)
                    for (int y = lo.y; y < hi.y; ++y)
                        for (int x = lo.x; x < hi.x; ++x)
                            sum +=
                                static_cast<double>(samples[static_cast<std::size_t>(x) +
                                                            static_cast<std::size_t>(size.x) *
                                                                (static_cast<std::size_t>(y) +
                                                                 static_cast<std::size_t>(size.y) *
                                                                     static_cast<std::size_t>(z))]);
                const glm::ivec3 count = hi - lo;
                out.samples[row * r + i] = static_cast<float>(sum / (count.x * count.y * count.z));
            }
    });
    return out;
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
    const double least = worth_a_look * *std::ranges::max_element(lengths);
    std::vector<double> change(n, 1e30);
    for (std::size_t i = 1; i + 1 < n; ++i)
        if (lengths[i] > least) change[i] = std::abs(lengths[i + 1] - lengths[i - 1]) / lengths[i];
    std::vector<std::size_t> out;
    for (std::size_t i = 1; i + 1 < n; ++i) {
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

LevelScout scout_levels(const VoxelGrid& grid, int levels, int most)
{
    if (levels < 3 || most < 2) throw Rejected("levels are scouted at 3 values or more");
    const CoarseGrid data = std::visit(
        [&](const auto& samples) { return coarse(samples, grid.size, most); }, grid.samples);
    const ScalarField<float> field(std::span<const float>(data.samples), data.size);
    const auto [least, greatest] = std::ranges::minmax(data.samples);
    LevelScout out;
    SilhouetteFinder find;
    for (int i = 0; i < levels; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(levels);
        const float at = std::lerp(least, greatest, share);
        const LevelMesh mesh =
            level_mesh(field, std::span<const float>(data.samples), at, LevelAccuracy::quick);
        double length = 0;
        for (const glm::dvec3& sight : scout_sights)
            length += length_of(find(field, mesh, {glm::dvec4(sight, 0)}));
        out.values.push_back(grid.value(double{at}));
        out.lengths.push_back(length / scout_sights.size());
    }
    if (grid.slope < 0) {
        std::ranges::reverse(out.values);
        std::ranges::reverse(out.lengths);
    }
    out.plateaus = plateaus_of(out.lengths);
    return out;
}

double snapped(const LevelScout& scout, double value, double reach)
{
    double out = value, least = reach;
    for (const std::size_t i : scout.plateaus)
        if (const double off = std::abs(scout.values[i] - value); off <= least) {
            least = off;
            out = scout.values[i];
        }
    return out;
}

} // namespace trivar
