// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/placement/scenes.h"

#include "core/mesh/primitives.h"

#include <cmath>

namespace trivar::testing {

Mesh height_field(double size, int steps, const std::function<double(double, double)>& height)
{
    Mesh mesh;
    const auto at = [&](int i) { return size * (static_cast<double>(i) / steps - 0.5); };
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            mesh.positions.emplace_back(at(i), at(j), height(at(i), at(j)));
    const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(i * (steps + 1) + j); };
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            for (const std::uint32_t c : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)})
                mesh.corners.push_back(c);
            mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        }
    return mesh;
}

RayScene scene_of(Mesh mesh, const glm::dmat4& to_world)
{
    return RayScene({{std::make_shared<const RayMesh>(make_ref(std::move(mesh))), to_world, 7}});
}

Camera from_above(double height)
{
    Camera c;
    c.eye = {0, 0, 10};
    c.target = {0, 0, 0};
    c.up = {0, 1, 0};
    c.perspective = false;
    c.height_world = height;
    c.size_px = {1500, 1000};
    return c;
}

Camera from_the_side(glm::dvec3 eye)
{
    Camera c;
    c.eye = eye;
    c.size_px = {1500, 1000};
    return c;
}

Sketch stroke(const Camera& camera, const std::vector<glm::dvec2>& corners_px)
{
    Sketch out{camera, {}};
    for (std::size_t i = 1; i < corners_px.size(); ++i) {
        const glm::dvec2 a = corners_px[i - 1], b = corners_px[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(b - a) / 5)));
        for (int k = i == 1 ? 0 : 1; k <= steps; ++k)
            out.samples.push_back({a + (b - a) * (static_cast<double>(k) / steps),
                                   0.01 * static_cast<double>(out.samples.size()), 1});
    }
    return out;
}

Sketch stroke_over(const Camera& camera, const std::vector<glm::dvec3>& corners_world)
{
    std::vector<glm::dvec2> px;
    for (const glm::dvec3& p : corners_world) px.push_back(project(camera, p).p_px);
    return stroke(camera, px);
}

std::vector<NamedScene> scenes_to_cover()
{
    const Ref<RayMesh> floor =
        std::make_shared<const RayMesh>(make_ref(plane_mesh({8, 8}, {2, 2})));
    std::vector<NamedScene> out;
    const auto add = [&](const char* name, Mesh mesh, double z) {
        glm::dmat4 raised(1);
        raised[3].z = z;
        const Ref<RayMesh> thing = std::make_shared<const RayMesh>(make_ref(std::move(mesh)));
        out.push_back({name, RayScene({{thing, raised, 1}, {floor, glm::dmat4(1), 2}})});
    };
    add("sphere", sphere_mesh(0.5, 60, 40), 0);
    add("box", box_mesh({0.8, 0.8, 0.6}, {1, 1, 1}), 0.3);
    add("wall thinner than the grid", box_mesh({0.004, 3, 0.3}, {1, 1, 1}), 0.15);
    add("torus", torus_mesh(0.5, 0.15, {80, 40}), 0.1);
    add("needle", cylinder_mesh(0.002, 0.4, 6, 1), 0.2);
    // Smooth noise of several wavelengths, the shortest about one cell of the grid.
    out.push_back({"noise", scene_of(height_field(4, 300, [](double x, double y) {
                       return 0.15 * sin(7 * x + 1) * sin(5 * y) +
                              0.06 * sin(19 * x + 2 * y) * cos(23 * y) +
                              0.02 * sin(61 * x) * sin(57 * y + 3 * x);
                   }))});
    return out;
}

Sketch stroke_to_cover(const Camera& camera)
{
    return stroke_over(camera, {{-1, -0.2, 0}, {0, 0.1, 0.2}, {1, 0, 0}});
}

Box snake_box()
{
    return {{-5, -1, 0}, {5, 1, 1}};
}

Placement placed(const Sketch& sketch, const RayScene& scene, const PlacementParameters& p)
{
    Timings timings;
    return place(sketch, p, snake_box(), scene, timings);
}

Placement over_waves(const PlacementParameters& p)
{
    static const RayScene waves = scene_of(height_field(
        20, 200, [](double x, double y) { return 0.03 * std::sin(2 * x) * std::cos(2 * y); }));
    Timings timings;
    const Camera camera = from_the_side({0.5, -1.5, 4});
    return place(stroke_over(camera, {{-1, 0, 0}, {1, 0.3, 0}}), p, snake_box(), waves, timings);
}

double penetration(const Surface<glm::dvec3>& contact, const Camera& camera, const RayScene& scene,
                   int n)
{
    double worst = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec2 uv((i + 0.5) / n, (j + 0.5) / n);
            const glm::dvec3 p = evaluate(contact, uv).value;
            const Ray ray = ray_through(camera, project(camera, p).p_px);
            const auto hit = scene.hit(ray);
            if (hit)
                worst = std::max(worst, glm::dot(p - ray.origin, ray.direction) - hit->distance);
        }
    return worst;
}

} // namespace trivar::testing
