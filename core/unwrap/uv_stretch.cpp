// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/uv_stretch.h"

#include <cmath>

namespace trivar {
namespace {

double turn_of(const std::array<glm::dvec2, 3>& uv)
{
    const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    return a.x * b.y - a.y * b.x;
}

double area_of(const std::array<glm::dvec3, 3>& p)
{
    return glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2;
}

void each_triangle(const Mesh& mesh, auto&& told)
{
    for (const glm::uvec3& t : triangles(mesh)) {
        std::array<glm::dvec3, 3> p;
        std::array<glm::dvec2, 3> uv;
        for (int k = 0; k < 3; ++k) {
            p[static_cast<std::size_t>(k)] = mesh.positions[t[k]];
            uv[static_cast<std::size_t>(k)] = mesh.uvs[0][t[k]];
        }
        told(t, p, uv);
    }
}

} // namespace

UvStretch uv_stretch(const std::array<glm::dvec3, 3>& triangle, const std::array<glm::dvec2, 3>& uv)
{
    const glm::dvec3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
    const double length = glm::length(a), twice = glm::length(glm::cross(a, b));
    if (!(length > 0) || !(twice > 0)) return {};
    // Derivatives along the triangle's first side and across it
    const double along = glm::dot(a, b) / length, across = twice / length;
    const glm::dvec2 x = (uv[1] - uv[0]) / length, y = (uv[2] - uv[0] - along * x) / across;
    // [x y] is a turn and scale plus a mirrored one; their sizes are half the sum and half the
    // difference of the singular values.
    const double sum = std::hypot(x.x + y.y, x.y - y.x), rest = std::hypot(x.x - y.y, x.y + y.x);
    return {(sum + rest) / 2, std::abs(sum - rest) / 2, sum < rest};
}

UvAreas uv_areas(const Mesh& mesh)
{
    UvAreas out;
    if (mesh.uvs.empty()) return out;
    each_triangle(mesh, [&](const glm::uvec3&, const auto& p, const auto& uv) {
        out.of_texture += std::abs(turn_of(uv)) / 2;
        out.of_surface += area_of(p);
    });
    return out;
}

std::vector<float> uv_values(const Mesh& mesh, UvMeasure measure, double usual)
{
    if (mesh.uvs.empty()) return {};
    constexpr double most = 1e6;
    std::vector<double> sums(mesh.vertex_count(), 0), areas(mesh.vertex_count(), 0);
    each_triangle(mesh, [&](const glm::uvec3& t, const auto& p, const auto& uv) {
        const UvStretch stretch = uv_stretch(p, uv);
        const double area = area_of(p);
        double value = measure == UvMeasure::angles ? stretch.angle() : stretch.area() / usual;
        // A triangle squeezed to a line counts as the worst.
        if (measure == UvMeasure::angles && stretch.least == 0) value = most;
        value = std::clamp(value, 1 / most, most) * (stretch.turned ? -1 : 1);
        for (int k = 0; k < 3; ++k) {
            sums[t[k]] += area * value;
            areas[t[k]] += area;
        }
    });
    std::vector<float> out(sums.size(), 1);
    for (std::size_t v = 0; v < out.size(); ++v)
        if (areas[v] > 0) out[v] = static_cast<float>(sums[v] / areas[v]);
    return out;
}

} // namespace trivar
