// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/casting/volumes.h"

#include <cmath>

namespace trivar::testing {
namespace {

template <class Sample>
Ref<VoxelGrid> grid_with(const glm::ivec3& size, const std::function<double(glm::dvec3)>& value)
{
    VoxelGrid grid;
    grid.size = size;
    std::vector<Sample> samples;
    samples.reserve(grid.count());
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                samples.push_back(static_cast<Sample>(value(glm::dvec3(x, y, z))));
    grid.samples = std::move(samples);
    return make_ref(std::move(grid));
}

} // namespace

Ref<VoxelGrid> grid_of(const glm::ivec3& size, const std::function<double(glm::dvec3)>& value)
{
    return grid_with<float>(size, value);
}

Ref<VoxelGrid> bytes_of(const glm::ivec3& size, const std::function<double(glm::dvec3)>& value)
{
    return grid_with<std::uint8_t>(
        size, [&](const glm::dvec3& p) { return std::round(glm::clamp(value(p), 0.0, 200.0)); });
}

double shells(const glm::dvec3& p, const glm::dvec3& middle)
{
    const double r = glm::distance(p, middle);
    return 100 + 100 * std::cos(0.55 * r) * std::exp(-0.04 * r);
}

Ref<VoxelField> field_of(const Ref<VoxelGrid>& grid, FieldOrder order)
{
    return std::make_shared<const VoxelField>(grid, VoxelFieldOptions{.order = order});
}

std::vector<TransferPoint> red_and_blue()
{
    return {{90, {1, 0, 0}, 0},
            {120, {0.9f, 0.2f, 0.1f}, 0.1},
            {150, {0.1f, 0.2f, 0.9f}, 0.05},
            {190, {0.2f, 0.3f, 1}, 0.3}};
}

} // namespace trivar::testing
