// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/level_bricks.h"

#include "core/level/kuhn_cells.h"

namespace trivar {
namespace {

using Rows = std::array<std::array<unsigned, 9>, 9>; // by z and y

// Whether all samples of a brick, with those after it, are on one side.
bool read_rows(const LatticeSigns& signs, const glm::ivec3& brick, Rows& rows)
{
    const unsigned mask = signs.mask(brick.x);
    unsigned any = 0, all = ~0u;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y) {
            const unsigned row = signs.row(8 * brick.y + y, 8 * brick.z + z, brick.x);
            rows[static_cast<std::size_t>(z)][static_cast<std::size_t>(y)] = row;
            any |= row & mask;
            all &= row | ~mask;
        }
    return any == 0 || all == ~0u;
}

void find_edges(const LatticeSigns& signs, const Rows& rows, LevelBrick& brick)
{
    const unsigned mask = signs.mask(brick.at.x), here = mask & 0xFF, next = mask >> 1 & 0xFF;
    for (int z = 0; z < 8 && 8 * brick.at.z + z < signs.size().z; ++z)
        for (int y = 0; y < 8 && 8 * brick.at.y + y < signs.size().y; ++y) {
            const bool has_y = 8 * brick.at.y + y + 1 < signs.size().y,
                       has_z = 8 * brick.at.z + z + 1 < signs.size().z;
            const auto row_at = [&](int dy, int dz) {
                return rows[static_cast<std::size_t>(z + dz)][static_cast<std::size_t>(y + dy)];
            };
            std::uint64_t crossing = 0;
            for (int d = 1; d < 8; ++d) {
                const int dx = d & 1, dy = d >> 1 & 1, dz = d >> 2;
                if ((dy && !has_y) || (dz && !has_z)) continue;
                const unsigned differ =
                    (row_at(0, 0) ^ (row_at(dy, dz) >> dx)) & (dx ? next : here);
                crossing |= std::uint64_t{differ} << (8 * d);
            }
            const auto row = static_cast<std::size_t>(y + 8 * z);
            brick.crossing[row] = crossing;
            brick.before[row] = static_cast<std::uint16_t>(brick.vertices);
            brick.vertices += number_of_bits(crossing);
            for_cells(signs, brick.at, y, z, [&](int, std::uint8_t inside) {
                brick.triangles += static_cast<std::uint32_t>(kuhn_triangles(inside).size());
            });
        }
}

} // namespace

LevelBricks level_bricks(const LatticeSigns& signs)
{
    LevelBricks out;
    out.count = signs.bricks();
    const auto rows_of_bricks =
        static_cast<std::size_t>(out.count.y) * static_cast<std::size_t>(out.count.z);
    std::vector<std::vector<LevelBrick>> by_row(rows_of_bricks);
    parallel_blocks(rows_of_bricks, 4, [&](std::size_t begin, std::size_t end) {
        Rows rows;
        for (std::size_t r = begin; r < end; ++r)
            for (int x = 0; x < out.count.x; ++x) {
                const auto n = static_cast<int>(r);
                const glm::ivec3 at(x, n % out.count.y, n / out.count.y);
                if (read_rows(signs, at, rows)) continue;
                LevelBrick brick{.at = at};
                find_edges(signs, rows, brick);
                if (brick.vertices > 0 || brick.triangles > 0) by_row[r].push_back(brick);
            }
    });
    out.number.assign(rows_of_bricks * static_cast<std::size_t>(out.count.x), -1);
    for (std::vector<LevelBrick>& row : by_row)
        for (LevelBrick& brick : row) {
            out.number[out.index(brick.at)] = static_cast<std::int32_t>(out.all.size());
            brick.first_vertex = out.vertices;
            brick.first_triangle = out.triangles;
            out.vertices += brick.vertices;
            out.triangles += brick.triangles;
            out.all.push_back(brick);
        }
    return out;
}

} // namespace trivar
