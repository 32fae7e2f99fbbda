// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tiles/bases.h"

namespace trivar::testing {

TileBase base_of(Mesh mesh, const glm::dmat4& to_model)
{
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    return TileBase({{std::make_shared<const RayMesh>(make_ref(std::move(mesh))), to_model}});
}

BasePose at_rest(const TileBase& base)
{
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) triangles.push_back(base.triangle(t));
    return {base.points(), angle_normals(base.points(), triangles)};
}

SurfacePlace random_place(const TileBase& base, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(0, 1);
    const double u = std::sqrt(share(random)), v = share(random);
    return {static_cast<std::uint32_t>(random() % base.triangle_count()),
            {1 - u, u * (1 - v), u * v}};
}

glm::dvec3 random_tangent(const TileBase& base, const SurfacePlace& at, std::mt19937& random)
{
    std::normal_distribution<double> number;
    const glm::dvec3 n = base.normal(at), v(number(random), number(random), number(random));
    return glm::normalize(v - glm::dot(v, n) * n);
}

TileStroke stroke_over(const TileBase& base, const glm::dvec3& from, const glm::dvec3& to,
                       const glm::dvec3& down, int samples)
{
    TileStroke stroke;
    for (int i = 0; i < samples; ++i) {
        const double share = samples > 1 ? static_cast<double>(i) / (samples - 1) : 0;
        const std::vector<SurfacePoint> over{{glm::mix(from, to, share), -down}};
        if (const auto at = base.locate(over, 2 * base.diagonal()).front())
            stroke.samples.push_back({{base.position(*at), base.normal(*at)}, share});
    }
    return stroke;
}

} // namespace trivar::testing
