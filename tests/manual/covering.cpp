// SPDX-License-Identifier: GPL-3.0-or-later
// Lays many strips over scenes and measures by other rays how much of each stays behind. Prints
// those that keep more than the promised thousandth of the height behind.
#include "core/placement/surface_table.h"
#include "core/placement/view.h"
#include "tests/placement/scenes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

using namespace testing;

constexpr int stiffnesses = 38; // from 0.02 to 2, evenly by their logarithms
constexpr int rays = 201;       // along each axis of a strip, at the middles of so many parts

// Metres that the surface lies behind what the camera sees.
double most_behind(const Surface<glm::dvec3>& contact, const Camera& camera, const RayScene& scene)
{
    const View view(camera);
    const std::vector<glm::dvec3> grid = SurfaceTable(contact).grid(glm::ivec2(2 * rays));
    std::vector<glm::dvec3> points;
    std::vector<Ray> through;
    for (int i = 0; i < rays; ++i)
        for (int j = 0; j < rays; ++j) {
            points.push_back(
                grid[static_cast<std::size_t>((2 * i + 1) * (2 * rays + 1) + 2 * j + 1)]);
            through.push_back(view.ray(view.project(points.back()).p_px));
        }
    const auto hits = scene.hits(through);
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (hits[k])
            worst = std::max(worst, glm::dot(points[k] - through[k].origin, through[k].direction) -
                                        hits[k]->distance);
    return worst;
}

void sample()
{
    int strokes = 0, exceeding = 0;
    for (const NamedScene& scene : scenes_to_cover())
        for (const Camera& camera : {from_above(3), from_the_side(), from_the_side({-3, -3, 2})})
            for (const double offset : {0.0, 1.0})
                for (int k = 0; k < stiffnesses; ++k) {
                    PlacementParameters asked;
                    asked.offset = offset;
                    asked.stiffness = 0.02 * std::pow(100.0, k / (stiffnesses - 1.0));
                    const Placement out = placed(stroke_to_cover(camera), scene.scene, asked);
                    const double share =
                        most_behind(out.contact, camera, scene.scene) / out.report.height_world;
                    ++strokes;
                    if (share <= asked.lift_tolerance) continue;
                    ++exceeding;
                    fmt::print("{}, from {:.0f} {:.0f} {:.0f}, offset {}, stiffness {:.4f}: "
                               "{:.5f} of the height\n",
                               scene.name, camera.eye.x, camera.eye.y, camera.eye.z, offset,
                               asked.stiffness, share);
                }
    fmt::print("{} of {} strokes exceed the promise\n", exceeding, strokes);
}

} // namespace
} // namespace trivar

int main()
{
    trivar::sample();
}
