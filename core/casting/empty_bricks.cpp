// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/empty_bricks.h"

#include <algorithm>

namespace trivar {
namespace {

// The neighbours that come before a brick, x fastest; those behind it are the opposite ones.
constexpr std::array<glm::ivec3, 13> neighbours_before{{{-1, -1, -1},
                                                        {0, -1, -1},
                                                        {1, -1, -1},
                                                        {-1, 0, -1},
                                                        {0, 0, -1},
                                                        {1, 0, -1},
                                                        {-1, 1, -1},
                                                        {0, 1, -1},
                                                        {1, 1, -1},
                                                        {-1, -1, 0},
                                                        {0, -1, 0},
                                                        {1, -1, 0},
                                                        {-1, 0, 0}}};

std::size_t number_of(const glm::ivec3& b, const glm::ivec3& count)
{
    return static_cast<std::size_t>(b.x) +
           static_cast<std::size_t>(count.x) *
               (static_cast<std::size_t>(b.y) +
                static_cast<std::size_t>(count.y) * static_cast<std::size_t>(b.z));
}

void reach_from(EmptyBricks& bricks, const glm::ivec3& b, int direction)
{
    std::uint8_t& here = bricks.reach[number_of(b, bricks.count)];
    for (const glm::ivec3& step : neighbours_before) {
        if (here == 0) return;
        const glm::ivec3 n = b + direction * step;
        if (glm::any(glm::lessThan(n, glm::ivec3(0))) ||
            glm::any(glm::greaterThanEqual(n, bricks.count)))
            continue;
        const int there = bricks.reach[number_of(n, bricks.count)];
        here = static_cast<std::uint8_t>(std::min<int>(here, there + 1));
    }
}

} // namespace

EmptyBricks empty_bricks(const FieldHulls& hulls, const TransferTable& transfer,
                         const glm::dvec2& share_of_sample)
{
    EmptyBricks out{hulls.bricks(), {}};
    const glm::ivec3 n = out.count;
    out.reach.reserve(number_of({0, 0, n.z}, n));
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) {
                const FieldHulls::Range& range = hulls.of({x, y, z});
                const double a = share_of_sample.x * range.least + share_of_sample.y,
                             b = share_of_sample.x * range.greatest + share_of_sample.y;
                const bool empty = transfer.empty(std::min(a, b), std::max(a, b));
                out.reach.push_back(empty ? 255 : 0);
            }
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) reach_from(out, {x, y, z}, 1);
    for (int z = n.z - 1; z >= 0; --z)
        for (int y = n.y - 1; y >= 0; --y)
            for (int x = n.x - 1; x >= 0; --x) reach_from(out, {x, y, z}, -1);
    return out;
}

} // namespace trivar
