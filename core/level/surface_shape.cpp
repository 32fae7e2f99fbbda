// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/surface_shape.h"

#include "core/base/parallel.h"
#include "core/mesh/vertex_corners.h"

namespace trivar {

float size_of(std::span<const glm::vec3> positions)
{
    glm::vec3 lo(1e30f), hi(-1e30f);
    for (const glm::vec3& p : positions) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    return positions.empty() ? 0 : glm::length(hi - lo);
}

void smooth_bends(SurfaceShape& shape, int times)
{
    if (times <= 0) return;
    const VertexCorners round(shape.corners, shape.positions.size());
    std::vector<SurfaceBend> next(shape.bends.size());
    for (int n = 0; n < times; ++n) {
        parallel_blocks(next.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                SurfaceBend sum;
                float count = 0;
                for (const std::uint32_t corner : round[i])
                    for (std::uint32_t k = 1; k < 3; ++k) {
                        const std::uint32_t other = corner - corner % 3 + (corner + k) % 3;
                        const SurfaceBend& near = shape.bends[shape.corners[other]];
                        for (std::size_t e = 0; e < 6; ++e) sum.b[e] += near.b[e];
                        ++count;
                    }
                next[i] = shape.bends[i];
                if (count == 0) continue;
                for (std::size_t e = 0; e < 6; ++e)
                    next[i].b[e] = (shape.bends[i].b[e] + sum.b[e] / count) / 2;
                next[i] = in_tangent_plane(next[i], shape.normals[i]);
            }
        });
        shape.bends.swap(next);
    }
}

glm::vec3 triangle_gradient(const SurfaceShape& shape, std::size_t triangle,
                            const std::array<float, 3>& values)
{
    const std::uint32_t* v = shape.corners.data() + 3 * triangle;
    const glm::vec3 a = shape.positions[v[1]] - shape.positions[v[0]],
                    b = shape.positions[v[2]] - shape.positions[v[0]];
    const float aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b),
                det = aa * bb - ab * ab;
    if (!(det > 1e-7f * aa * bb)) return glm::vec3(0);
    const float on_a = values[1] - values[0], on_b = values[2] - values[0];
    return ((on_a * bb - on_b * ab) * a + (on_b * aa - on_a * ab) * b) / det;
}

std::vector<glm::vec3> vertex_gradients(const SurfaceShape& shape, std::span<const float> values)
{
    const VertexCorners round(shape.corners, shape.positions.size());
    std::vector<glm::vec3> of_triangle(shape.corners.size() / 3), out(shape.positions.size());
    std::vector<float> areas(of_triangle.size());
    parallel_blocks(of_triangle.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const std::uint32_t* v = shape.corners.data() + 3 * t;
            of_triangle[t] =
                triangle_gradient(shape, t, {values[v[0]], values[v[1]], values[v[2]]});
            areas[t] = glm::length(glm::cross(shape.positions[v[1]] - shape.positions[v[0]],
                                              shape.positions[v[2]] - shape.positions[v[0]]));
        }
    });
    parallel_blocks(out.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float area = 0;
            for (const std::uint32_t corner : round[i]) {
                out[i] += areas[corner / 3] * of_triangle[corner / 3];
                area += areas[corner / 3];
            }
            if (area > 0) out[i] /= area;
        }
    });
    return out;
}

} // namespace trivar
