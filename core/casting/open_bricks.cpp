// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/open_bricks.h"

#include "core/base/parallel.h"
#include "core/casting/empty_bricks.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int brick_cells = FieldHulls::brick;

struct BrickGrid {
    glm::ivec3 count;
    std::size_t at(const glm::ivec3& b) const
    {
        return static_cast<std::size_t>(b.x) +
               static_cast<std::size_t>(count.x) *
                   (static_cast<std::size_t>(b.y) +
                    static_cast<std::size_t>(count.y) * static_cast<std::size_t>(b.z));
    }
    bool has(const glm::ivec3& b) const
    {
        return glm::all(glm::greaterThanEqual(b, glm::ivec3(0))) &&
               glm::all(glm::lessThan(b, count));
    }
    void each_in_layer(int z, auto&& visit) const
    {
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) visit(glm::ivec3(x, y, z));
    }
    void each(auto&& visit) const // in parallel, by layers
    {
        parallel_blocks(static_cast<std::size_t>(count.z), 1, [&](std::size_t z, std::size_t) {
            each_in_layer(static_cast<int>(z), visit);
        });
    }
};

// The mean density of a brick per voxel, of every other coefficient along each axis.
float mean_density(const ScalarField<float>& field, const glm::ivec3& brick,
                   const TransferTable& transfer, const glm::dvec2& share_of_sample)
{
    float sum = 0;
    int count = 0;
    const glm::ivec3 first = brick * brick_cells, end = field.size();
    for (int z = first.z; z < std::min(first.z + brick_cells, end.z); z += 2)
        for (int y = first.y; y < std::min(first.y + brick_cells, end.y); y += 2)
            for (int x = first.x; x < std::min(first.x + brick_cells, end.x); x += 2) {
                const double u =
                    share_of_sample.x * double{field.coefficient(x, y, z)} + share_of_sample.y;
                const auto cell = static_cast<std::size_t>(
                    std::clamp(u * TransferTable::cells, 0.0, TransferTable::cells - 1.0));
                sum += (transfer.before[cell + 1].a - transfer.before[cell].a) *
                       static_cast<float>(TransferTable::cells);
                ++count;
            }
    return count > 0 ? sum / static_cast<float>(count) : 0;
}

// The share of the light that comes through from one direction.
float let_through(const BrickGrid& grid, const std::vector<float>& density, const glm::ivec3& brick,
                  const glm::ivec3& direction)
{
    constexpr std::array<int, 5> stops{1, 2, 3, 5, 9}; // each stands for the way to the next
    constexpr std::array<float, 5> ways{0.75f, 1, 1.5f, 3, 4};
    const float length = glm::length(glm::vec3(direction));
    float held = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        // Diagonals have fewer bricks on the same way.
        const glm::vec3 step = glm::vec3(direction) * (static_cast<float>(stops[i]) / length);
        const glm::ivec3 there = brick + glm::ivec3(glm::round(step));
        if (!grid.has(there)) break;
        held += density[grid.at(there)] * ways[i] * brick_cells;
    }
    return std::exp(-held);
}

} // namespace

OpenBricks open_bricks(const ScalarField<float>& field, const EmptyBricks& empty,
                       const TransferTable& transfer, const glm::dvec2& share_of_sample)
{
    constexpr int directions = 14;
    const BrickGrid grid{empty.count};
    std::vector<float> density(empty.reach.size(), 0.0f);
    grid.each([&](const glm::ivec3& b) {
        if (empty.reach[grid.at(b)] == 0)
            density[grid.at(b)] = mean_density(field, b, transfer, share_of_sample);
    });
    OpenBricks out{empty.count, std::vector<std::uint8_t>(empty.reach.size(), 255)};
    grid.each([&](const glm::ivec3& b) {
        if (empty.reach[grid.at(b)] > 2) return;
        float sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                glm::ivec3 direction(0);
                direction[axis] = sign;
                sum += let_through(grid, density, b, direction);
            }
        for (int k = 0; k < 8; ++k)
            sum += let_through(grid, density, b, {k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1});
        out.share[grid.at(b)] = static_cast<std::uint8_t>(sum / directions * 255 + 0.5f);
    });
    return out;
}

} // namespace trivar
