// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/transfer.h"

#include "core/voxels/usual_level.h"

#include <algorithm>

namespace trivar {
namespace {

std::vector<TransferPoint> in_order(std::span<const TransferPoint> points)
{
    std::vector<TransferPoint> out(points.begin(), points.end());
    std::ranges::stable_sort(out, {}, &TransferPoint::value);
    return out;
}

glm::vec4 look_of(const TransferPoint& point)
{
    return {glm::clamp(point.color, 0.0f, 1.0f),
            static_cast<float>(std::clamp(point.opacity, 0.0, 1.0))};
}

glm::vec4 between_points(const std::vector<TransferPoint>& ordered, double value)
{
    const auto above =
        std::ranges::upper_bound(ordered, value, std::less<>(), &TransferPoint::value);
    if (above == ordered.begin()) return look_of(ordered.front());
    if (above == ordered.end()) return look_of(ordered.back());
    const TransferPoint &lower = *(above - 1), &upper = *above;
    const double share = (value - lower.value) / (upper.value - lower.value);
    return glm::mix(look_of(lower), look_of(upper), static_cast<float>(share));
}

} // namespace

glm::vec4 transfer_at(std::span<const TransferPoint> points, double value)
{
    return points.empty() ? glm::vec4(0) : between_points(in_order(points), value);
}

std::array<glm::vec4, 256> transfer_colors(std::span<const TransferPoint> points, double least,
                                           double greatest)
{
    std::array<glm::vec4, 256> out{};
    if (points.empty()) return out;
    const std::vector<TransferPoint> ordered = in_order(points);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = between_points(ordered, least + (greatest - least) *
                                                     (static_cast<double>(i) + 0.5) / out.size());
    return out;
}

std::vector<TransferPoint> usual_transfer(const VolumeSummary& summary, const VoxelGrid& grid)
{
    constexpr glm::vec3 skin{0.93f, 0.66f, 0.50f}, flesh{0.80f, 0.36f, 0.28f},
        bone{0.97f, 0.93f, 0.85f};
    const auto [lower, upper] = usual_levels(summary, grid);
    const double soft = std::min(0.03 * (summary.greatest - summary.least), 0.2 * (upper - lower));
    return {{lower, skin, 0},
            {lower + 2 * soft, skin, 0.05},
            {lower + 3.5 * soft, flesh, 0.01},
            {upper, flesh, 0.015},
            {upper + 2 * soft, bone, 0.45},
            {std::max(summary.greatest, upper + 3 * soft), glm::vec3(1), 0.8}};
}

} // namespace trivar
