// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/preview.h"

#include "core/base/rejected.h"
#include "core/placement/contact.h"
#include "core/placement/layout.h"
#include "core/placement/sketch.h"

namespace trivar {
namespace {

constexpr int lines_across = 48;

double length_of(const RayGrid& line)
{
    std::vector<glm::dvec3> points, views;
    for (std::size_t k = 0; k < line.rays.size(); ++k) {
        points.push_back(line.point(k));
        views.push_back(line.rays[k].direction);
    }
    return walked_length(points, views).back();
}

std::vector<std::vector<glm::dvec3>> strip_lines(const Sketch& sketch, double width,
                                                 const RayScene& scene)
{
    const Curve<glm::dvec2> curve = fit_sketch(stroke_points(sketch));
    const RayGrid center = center_line(curve, lines_across + 1, sketch.camera, scene, false);
    if (!(width > 0)) width = length_of(center) / 5;
    const Strip strip =
        strip_round(curve, half_width_px(center, sketch.camera, width, lines_across + 1));
    std::vector<double> v;
    for (int i = 0; i <= lines_across; ++i) v.insert(v.end(), {0.5, 0.0, 1.0});
    RayGrid grid = shoot(strip, center.a, std::move(v), sketch.camera, scene, false);
    if (grid.missed_share() == 1) return {};
    grid = filled(std::move(grid), Misses::nearest);
    std::vector<std::vector<glm::dvec3>> out(3);
    for (int i = 0; i < grid.rows; ++i)
        for (int j = 0; j < 3; ++j)
            out[static_cast<std::size_t>(j)].push_back(grid.point(grid.index(i, j)));
    return out;
}

} // namespace

std::vector<std::vector<glm::dvec3>> preview_strip(const Sketch& sketch, double width,
                                                   const RayScene& scene)
{
    // What a finished stroke would be rejected for is the normal state of one just begun.
    try {
        return strip_lines(sketch, width, scene);
    } catch (const Rejected&) {
        return {};
    }
}

} // namespace trivar
