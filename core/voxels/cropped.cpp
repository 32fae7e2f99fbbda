// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/cropped.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {

SampleBox sample_box(const glm::ivec3& size, const glm::vec3& low, const glm::vec3& high)
{
    const glm::vec3 cells(size - 1);
    const glm::ivec3 first =
        glm::clamp(glm::ivec3(glm::round(low * cells)), glm::ivec3(0), size - 2);
    return {first, glm::clamp(glm::ivec3(glm::round(high * cells)), first + 1, size - 1)};
}

VoxelGrid cropped(const VoxelGrid& grid, const SampleBox& box)
{
    VoxelGrid out;
    out.size = box.size();
    out.samples = std::visit(
        [&](const auto& samples) -> VoxelGrid::Samples {
            return cropped(std::span(samples), grid.size, box);
        },
        grid.samples);
    out.slope = grid.slope;
    out.intercept = grid.intercept;
    out.value_unit = grid.value_unit;
    out.notices = grid.notices;
    out.to_metres = cropped_place(grid.to_metres, box);
    return out;
}

glm::dmat4 cropped_place(const glm::dmat4& to_metres, const SampleBox& box)
{
    return glm::translate(to_metres, glm::dvec3(box.first));
}

} // namespace trivar
