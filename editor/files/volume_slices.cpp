// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/volume_slices.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// GridAxes tells which axis of the grid goes most along each axis of space, and which way.
struct GridAxes {
    std::array<int, 3> axis{0, 1, 2};
    std::array<bool, 3> backwards{};
    std::array<double, 3> step{1, 1, 1}; // metres
};

GridAxes axes_of(const glm::dmat4& to_metres)
{
    GridAxes out;
    std::array<bool, 3> used{};
    for (int w = 0; w < 3; ++w) {
        int best = -1;
        double most = -1;
        for (int a = 0; a < 3; ++a) {
            const glm::dvec3 step(to_metres[a]);
            const double share = std::abs(step[w]) / glm::length(step);
            if (used[static_cast<std::size_t>(a)] || share <= most) continue;
            most = share;
            best = a;
        }
        const auto k = static_cast<std::size_t>(w);
        used[static_cast<std::size_t>(best)] = true;
        out.axis[k] = best;
        out.backwards[k] = to_metres[best][w] < 0;
        out.step[k] = glm::length(glm::dvec3(to_metres[best]));
    }
    return out;
}

// The values between which all but a thousandth at either end lie.
std::array<double, 2> shown_range(const VolumeSummary& s)
{
    std::uint64_t all = 0;
    for (const std::uint64_t n : s.histogram) all += n;
    const double part = (s.greatest - s.least) / static_cast<double>(s.histogram.size());
    std::uint64_t below = 0;
    double lo = s.least, hi = s.greatest;
    bool low_found = false;
    for (std::size_t i = 0; i < s.histogram.size(); ++i) {
        below += s.histogram[i];
        if (!low_found && below * 1000 > all) {
            lo = s.least + part * static_cast<double>(i);
            low_found = true;
        }
        if (below * 1000 >= all * 999) {
            hi = s.least + part * static_cast<double>(i + 1);
            break;
        }
    }
    return {lo, hi > lo ? hi : lo + 1};
}

// A plane that is seen with axes of space to the right and down, as the patient lies or stands.
struct SlicePlane {
    int right, down, through;
    bool upward; // the image goes against the axis of space that is told as down
};

VolumeSlice slice_of(const VoxelGrid& grid, const GridAxes& axes, const SlicePlane& plane,
                     const std::array<double, 2>& range)
{
    constexpr double most = 320;
    const auto k = [](int i) { return static_cast<std::size_t>(i); };
    const int a = axes.axis[k(plane.right)], b = axes.axis[k(plane.down)],
              c = axes.axis[k(plane.through)];
    const double width = (grid.size[a] - 1) * axes.step[k(plane.right)],
                 height = (grid.size[b] - 1) * axes.step[k(plane.down)];
    VolumeSlice out;
    out.shape = std::clamp(width / height, 0.05, 20.0);
    const double by = std::max(1.0, std::max(grid.size[a], grid.size[b]) / most);
    out.image.size_px = glm::max(
        glm::ivec2(static_cast<int>(grid.size[a] / by), static_cast<int>(grid.size[b] / by)),
        glm::ivec2(1));
    out.image.rgba.reserve(k(out.image.size_px.x) * k(out.image.size_px.y) * 4);
    const bool flip_x = axes.backwards[k(plane.right)],
               flip_y = axes.backwards[k(plane.down)] != plane.upward;
    std::visit(
        [&](const auto& samples) {
            for (int y = 0; y < out.image.size_px.y; ++y)
                for (int x = 0; x < out.image.size_px.x; ++x) {
                    glm::ivec3 at(0);
                    at[c] = grid.size[c] / 2;
                    at[a] = std::min(grid.size[a] - 1, static_cast<int>((x + 0.5) * by));
                    at[b] = std::min(grid.size[b] - 1, static_cast<int>((y + 0.5) * by));
                    if (flip_x) at[a] = grid.size[a] - 1 - at[a];
                    if (flip_y) at[b] = grid.size[b] - 1 - at[b];
                    const std::size_t i =
                        k(at.x) + k(grid.size.x) * (k(at.y) + k(grid.size.y) * k(at.z));
                    const double value = grid.value(static_cast<double>(samples[i]));
                    const double share = (value - range[0]) / (range[1] - range[0]);
                    const double grey = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0;
                    const auto byte = static_cast<std::uint8_t>(std::lround(255 * grey));
                    for (int channel = 0; channel < 3; ++channel) out.image.rgba.push_back(byte);
                    out.image.rgba.push_back(255);
                }
        },
        grid.samples);
    return out;
}

} // namespace

namespace {

std::array<VolumeSlice, 3> slices_along(const glm::dmat4& to_space, const VoxelGrid& grid,
                                        const VolumeSummary& summary)
{
    const GridAxes axes = axes_of(to_space);
    const std::array<double, 2> range = shown_range(summary);
    // y goes to the back, which is below in a picture from above; z goes to the head.
    return {slice_of(grid, axes, {0, 1, 2, false}, range),
            slice_of(grid, axes, {0, 2, 1, true}, range),
            slice_of(grid, axes, {1, 2, 0, true}, range)};
}

} // namespace

std::array<VolumeSlice, 3> middle_slices(const VoxelGrid& grid, const VolumeSummary& summary)
{
    return slices_along(grid.to_metres, grid, summary);
}

std::array<VolumeSlice, 3> turned_slices(const VolumeOffer& offer)
{
    Transform turn;
    turn.rotation_deg = command_of(offer).transform.rotation_deg;
    return slices_along(turn.matrix() * offer.grid->to_metres, *offer.grid, *offer.summary);
}

} // namespace trivar
