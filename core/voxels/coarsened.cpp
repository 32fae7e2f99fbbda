// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/coarsened.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <type_traits>

namespace trivar {
namespace {

template <class Sample>
std::vector<Sample> means(const std::vector<Sample>& samples, const glm::ivec3& size,
                          const glm::ivec3& to, const glm::ivec3& step)
{
    const auto place = [](const glm::ivec3& p, const glm::ivec3& in) {
        return static_cast<std::size_t>(p.x) +
               static_cast<std::size_t>(in.x) *
                   (static_cast<std::size_t>(p.y) +
                    static_cast<std::size_t>(in.y) * static_cast<std::size_t>(p.z));
    };
    std::vector<Sample> out(place({0, 0, to.z}, to));
    const double share = 1.0 / (static_cast<double>(step.x) * step.y * step.z);
    // Works by rows, so that all threads share even a single slice.
    const auto height = static_cast<std::size_t>(to.y);
    parallel_blocks(
        height * static_cast<std::size_t>(to.z), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                const int y = static_cast<int>(row % height), z = static_cast<int>(row / height);
                for (int x = 0; x < to.x; ++x) {
                    double sum = 0;
                    for (int k = 0; k < step.z; ++k)
                        for (int j = 0; j < step.y; ++j)
                            for (int i = 0; i < step.x; ++i)
                                sum += static_cast<double>(samples[place(
                                    glm::ivec3(x, y, z) * step + glm::ivec3(i, j, k), size)]);
                    if constexpr (std::is_integral_v<Sample>) sum = std::round(sum * share) / share;
                    out[place({x, y, z}, to)] = static_cast<Sample>(sum * share);
                }
            }
        });
    return out;
}

} // namespace

glm::ivec3 coarsening_steps(const glm::ivec3& size, const glm::ivec3& times)
{
    return glm::clamp(size / 2, glm::ivec3(1), glm::max(times, glm::ivec3(1)));
}

VoxelGrid::Samples coarsened_samples(const VoxelGrid::Samples& samples, const glm::ivec3& size,
                                     const glm::ivec3& step)
{
    return std::visit(
        [&](const auto& all) -> VoxelGrid::Samples { return means(all, size, size / step, step); },
        samples);
}

glm::dmat4 coarsened_place(const glm::dmat4& to_metres, const glm::ivec3& step)
{
    return glm::scale(glm::translate(to_metres, (glm::dvec3(step) - 1.0) / 2.0), glm::dvec3(step));
}

VoxelGrid coarsened(const VoxelGrid& grid, const glm::ivec3& times)
{
    const glm::ivec3 step = coarsening_steps(grid.size, times);
    VoxelGrid out;
    out.size = grid.size / step;
    out.samples = coarsened_samples(grid.samples, grid.size, step);
    out.slope = grid.slope;
    out.intercept = grid.intercept;
    out.value_unit = grid.value_unit;
    out.notices = grid.notices;
    out.to_metres = coarsened_place(grid.to_metres, step);
    return out;
}

} // namespace trivar
