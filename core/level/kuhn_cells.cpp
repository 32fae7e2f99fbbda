// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/kuhn_cells.h"

#include "core/simplex/level_ring.h"

#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace trivar {
namespace {

using Triangle = std::array<KuhnEdge, 3>;

glm::vec3 place_of(int corner)
{
    return {corner & 1, corner >> 1 & 1, corner >> 2};
}

KuhnEdge edge_between(int a, int b)
{
    if ((a & b) != a) std::swap(a, b);
    return {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(a ^ b)};
}

glm::vec3 middle_of(const KuhnEdge& edge)
{
    return (place_of(edge.corner) + place_of(edge.corner | edge.direction)) / 2.0f;
}

// Turned so that its normal points away from the corners inside.
Triangle turned(Triangle t, const glm::vec3& outward)
{
    const glm::vec3 a = middle_of(t[0]),
                    normal = glm::cross(middle_of(t[1]) - a, middle_of(t[2]) - a);
    if (glm::dot(normal, outward) < 0) std::swap(t[1], t[2]);
    return t;
}

// The triangles of one tetrahedron.
void add_triangles(const std::array<int, 4>& corners, unsigned inside, std::vector<Triangle>& out)
{
    std::array<bool, 4> is_in{};
    glm::vec3 in_sum(0), beyond_sum(0);
    int count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        is_in[k] = inside >> corners[k] & 1;
        (is_in[k] ? in_sum : beyond_sum) += place_of(corners[k]);
        count += is_in[k] ? 1 : 0;
    }
    const LevelRing cut = level_ring(is_in);
    const glm::vec3 outward =
        beyond_sum / static_cast<float>(4 - count) - in_sum / static_cast<float>(count);
    const auto edge = [&](std::size_t i) {
        return edge_between(corners[cut.edges[i].above], corners[cut.edges[i].below]);
    };
    for (std::size_t i = 1; i + 1 < cut.size; ++i)
        out.push_back(turned({edge(0), edge(i), edge(i + 1)}, outward));
}

std::array<std::vector<Triangle>, 256> all_cells()
{
    constexpr std::array<std::array<int, 4>, 6> tetrahedra{
        {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
    std::array<std::vector<Triangle>, 256> out;
    for (unsigned inside = 0; inside < 256; ++inside)
        for (const std::array<int, 4>& corners : tetrahedra)
            add_triangles(corners, inside, out[inside]);
    return out;
}

} // namespace

std::span<const std::array<KuhnEdge, 3>> kuhn_triangles(std::uint8_t inside)
{
    static const std::array<std::vector<Triangle>, 256> cells = all_cells();
    return cells[inside];
}

} // namespace trivar
