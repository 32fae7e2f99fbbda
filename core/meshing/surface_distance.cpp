// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/surface_distance.h"

#include "core/base/share_along.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t leaf_size = 4; // triangles, at most

glm::dvec3 nearest_on_segment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& x)
{
    return a + (b - a) * share_along(x, a, b - a);
}

// Inside of all three edges it is the foot on the plane, else on one of the edges.
glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& c, const glm::dvec3& x)
{
    const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double n2 = glm::dot(n, n);
    bool inside = n2 > 0;
    for (std::size_t i = 0; inside && i < 3; ++i)
        inside = glm::dot(glm::cross(c[(i + 1) % 3] - c[i], x - c[i]), n) >= 0;
    if (inside) return x - n * (glm::dot(x - c[0], n) / n2);
    glm::dvec3 best = nearest_on_segment(c[0], c[1], x);
    for (std::size_t i = 1; i < 3; ++i) {
        const glm::dvec3 p = nearest_on_segment(c[i], c[(i + 1) % 3], x);
        if (glm::distance(p, x) < glm::distance(best, x)) best = p;
    }
    return best;
}

} // namespace

SurfaceDistance::SurfaceDistance(std::span<const glm::dvec3> positions,
                                 std::span<const std::array<int, 3>> triangles)
{
    for (const auto& t : triangles) {
        Frame frame;
        for (std::size_t i = 0; i < 3; ++i)
            frame.corners[i] = positions[static_cast<std::size_t>(t[i])];
        triangles_.push_back(frame);
    }
    while ((leaf_size << leaf_level_) < triangles_.size()) ++leaf_level_;
    boxes_.resize((std::size_t(2) << leaf_level_) - 1);
    build(0, triangles_);
}

// Halves of equal number along the longest side, so that where a node's triangles lie follows
// from its number.
void SurfaceDistance::build(std::size_t node, std::span<Frame> triangles)
{
    Box& box = boxes_[node];
    for (const Frame& t : triangles)
        for (const glm::dvec3& p : t.corners) box.add(p);
    if (2 * node + 2 >= boxes_.size()) return;
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = triangles.size() / 2;
    std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     triangles.end(), [axis](const Frame& a, const Frame& b) {
                         return a.corners[0][axis] + a.corners[1][axis] + a.corners[2][axis] <
                                b.corners[0][axis] + b.corners[1][axis] + b.corners[2][axis];
                     });
    build(2 * node + 1, triangles.first(half));
    build(2 * node + 2, triangles.subspan(half));
}

glm::dvec3 SurfaceDistance::nearest(const glm::dvec3& x) const
{
    struct Node {
        std::size_t number, first, count;
        double distance;
    };
    std::array<Node, 64> stack;
    std::size_t top = 0;
    stack[top++] = {0, 0, triangles_.size(), 0};
    glm::dvec3 best(0);
    double best_distance = 1e300;
    while (top > 0) {
        const Node node = stack[--top];
        if (node.distance >= best_distance) continue;
        if (2 * node.number + 2 >= boxes_.size()) {
            for (std::size_t t = node.first; t < node.first + node.count; ++t) {
                const glm::dvec3 p = nearest_on_triangle(triangles_[t].corners, x);
                const double d = glm::distance(p, x);
                if (d < best_distance) best = p, best_distance = d;
            }
            continue;
        }
        const std::size_t half = node.count / 2;
        Node a{2 * node.number + 1, node.first, half, 0};
        Node b{2 * node.number + 2, node.first + half, node.count - half, 0};
        a.distance = boxes_[a.number].distance(x);
        b.distance = boxes_[b.number].distance(x);
        if (a.distance < b.distance) std::swap(a, b);
        if (a.count > 0) stack[top++] = a; // the nearer one is looked at first
        if (b.count > 0) stack[top++] = b;
    }
    return best;
}

} // namespace trivar
