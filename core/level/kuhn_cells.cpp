// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/kuhn_cells.h"

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
    std::vector<int> in, beyond;
    glm::vec3 in_sum(0), beyond_sum(0);
    for (const int c : corners) {
        const bool is_in = inside >> c & 1;
        (is_in ? in : beyond).push_back(c);
        (is_in ? in_sum : beyond_sum) += place_of(c);
    }
    if (in.empty() || beyond.empty()) return;
    const glm::vec3 outward =
        beyond_sum / static_cast<float>(beyond.size()) - in_sum / static_cast<float>(in.size());
    if (in.size() == 2) {
        const KuhnEdge a = edge_between(in[0], beyond[0]), b = edge_between(in[0], beyond[1]),
                       c = edge_between(in[1], beyond[1]), d = edge_between(in[1], beyond[0]);
        out.push_back(turned({a, b, c}, outward));
        out.push_back(turned({a, c, d}, outward));
        return;
    }
    const std::vector<int>&alone = in.size() == 1 ? in : beyond,
          &others = in.size() == 1 ? beyond : in;
    out.push_back(turned({edge_between(alone[0], others[0]), edge_between(alone[0], others[1]),
                          edge_between(alone[0], others[2])},
                         outward));
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
