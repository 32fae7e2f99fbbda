// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/check.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"

#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

void in_range(double value, double lo, double hi, const char* name)
{
    if (!(value >= lo && value <= hi))
        throw Rejected(fmt::format("{} is {} but must be from {} to {}", name,
                                   number_text(value, {.digits = 6}), number_text(lo),
                                   number_text(hi)));
}

} // namespace

void check(const PlacementParameters& p)
{
    constexpr double largest = 1e9; // metres
    in_range(p.width, 0, largest, "the width");
    in_range(p.height, 0, largest, "the height");
    in_range(p.offset, 0, 1, "the offset");
    in_range(p.stiffness, 1e-3, 1e3, "the stiffness");
    in_range(p.bending, 0, 10, "the bending");
    in_range(p.neighborhood, 0, most_along_or_across, "the neighbourhood");
    in_range(p.roughness_deg, 1, 90, "the roughness angle");
    in_range(p.start, 0, 1, "the start");
    in_range(p.fill, 1e-6, 1, "the fill");
    in_range(p.start + p.fill, 0, 1 + 1e-12, "start plus fill");
    in_range(p.lift_tolerance, 1e-6, 1, "the lift tolerance");
    in_range(p.clearance, 0, largest, "the clearance");
    in_range(p.roll_deg, -1e6, 1e6, "the roll");
    check_profile(p.width_profile, "the profile of the width");
    check_profile(p.height_profile, "the profile of the height");
    check_profile(p.height_across, "the profile of the height across");
    check_height_map(p.height_map, "the height map");
    check_rise(p.rise_profile, "the height distribution");
    in_range(p.contact_level, 0, 1, "the contact level");
    const std::array<const char*, 3> axis{"along", "across", "above"};
    for (int a = 0; a < 3; ++a) {
        const char* name = axis[static_cast<std::size_t>(a)];
        in_range(p.orders[a], 2, max_order, fmt::format("the order {} the stroke", name).c_str());
        in_range(p.grid[a], p.orders[a], a < 2 ? most_along_or_across : most_layers,
                 fmt::format("the number of control points {} the stroke", name).c_str());
    }
}

// Throws Rejected if the camera is inside a closed object: rays in every direction meet it from
// inside.
void check_enclosed(const Camera& camera, const RayScene& scene)
{
    int inside = 0;
    const double r = std::sqrt(1.0 / 3);
    std::vector<Ray> rays;
    for (const double x : {-r, r})
        for (const double y : {-r, r})
            for (const double z : {-r, r}) rays.push_back({camera.eye, {x, y, z}});
    for (const auto& hit : scene.hits(rays)) inside += hit && hit->back_face;
    if (inside == 8)
        throw Rejected("the camera is inside an object; move it out or skip back faces");
}

} // namespace trivar
