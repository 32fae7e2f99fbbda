// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/point_choice.h"

#include <algorithm>
#include <utility>

namespace trivar {
glm::ivec3 point_count(const Lattice& volume)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    return {axes[0].count(), axes[1].count(), axes[2].count()};
}

int number_of(const glm::ivec3& point, const glm::ivec3& count)
{
    return (point.x * count.y + point.y) * count.z + point.z;
}

glm::ivec3 point_of(int number, const glm::ivec3& count)
{
    return {number / count.z / count.y, number / count.z % count.y, number % count.z};
}

Points within(Points points, const glm::ivec3& count)
{
    std::erase_if(points, [&](const glm::ivec3& p) {
        return p.x >= count.x || p.y >= count.y || p.z >= count.z;
    });
    return points;
}

Points all_points(const glm::ivec3& count)
{
    Points out;
    for (int i = 0; i < count.x; ++i)
        for (int j = 0; j < count.y; ++j)
            for (int k = 0; k < count.z; ++k) out.emplace_back(i, j, k);
    return out;
}

Points row_of(const glm::ivec3& point, int axis, const glm::ivec3& count)
{
    Points out(static_cast<std::size_t>(count[axis]), point);
    for (int i = 0; i < count[axis]; ++i) out[static_cast<std::size_t>(i)][axis] = i;
    return out;
}

Points plane_of(const glm::ivec3& point, int axis, const glm::ivec3& count)
{
    Points out = all_points(count);
    std::erase_if(out, [&](const glm::ivec3& p) { return p[axis] != point[axis]; });
    return out;
}

Points with_next(const Points& chosen, const glm::ivec3& count)
{
    std::vector<char> known(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                            static_cast<std::size_t>(count.z));
    const auto flag = [&](const glm::ivec3& p) -> char& {
        return known[static_cast<std::size_t>(number_of(p, count))];
    };
    for (const glm::ivec3& p : chosen) flag(p) = 1;
    Points out = chosen;
    for (const glm::ivec3& p : chosen)
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                glm::ivec3 next = p;
                next[axis] += step;
                if (next[axis] < 0 || next[axis] >= count[axis]) continue;
                if (std::exchange(flag(next), 1) == 0) out.push_back(next);
            }
    return out;
}

} // namespace trivar
