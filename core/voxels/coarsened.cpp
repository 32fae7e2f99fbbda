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
    parallel_blocks(static_cast<std::size_t>(to.z), 1, [&](std::size_t slice, std::size_t) {
        const int z = static_cast<int>(slice);
        for (int y = 0; y < to.y; ++y)
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
    });
    return out;
}

} // namespace

VoxelGrid coarsened(const VoxelGrid& grid, const glm::ivec3& times)
{
    const glm::ivec3 step =
        glm::clamp(grid.size / 2, glm::ivec3(1), glm::max(times, glm::ivec3(1)));
    VoxelGrid out;
    out.size = grid.size / step;
    out.samples = std::visit(
        [&](const auto& samples) -> VoxelGrid::Samples {
            return means(samples, grid.size, out.size, step);
        },
        grid.samples);
    out.slope = grid.slope;
    out.intercept = grid.intercept;
    out.value_unit = grid.value_unit;
    out.notices = grid.notices;
    out.to_metres = glm::scale(glm::translate(grid.to_metres, (glm::dvec3(step) - 1.0) / 2.0),
                               glm::dvec3(step));
    return out;
}

} // namespace trivar
