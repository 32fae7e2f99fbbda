// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_masks.h"

#include "core/base/share_along.h"
#include "core/base/smooth_step.h"
#include "core/tiles/layout.h"

#include <algorithm>

namespace trivar {
namespace {

double eased(double t, MaskEasing easing)
{
    switch (easing) {
    case MaskEasing::even: return t;
    case MaskEasing::smooth: return smooth_step(t);
    case MaskEasing::slow_start: return t * t;
    case MaskEasing::slow_end: return t * (2 - t);
    }
    return t;
}

// Returns the value at a distance: 1 up to `start`, 0 from `stop` on, eased between.
double near_value(double distance, const TileMask& mask)
{
    const double width = mask.stop - mask.start;
    if (!(std::abs(width) > 0)) return distance <= mask.start ? 1 : 0;
    return eased(std::clamp((mask.stop - distance) / width, 0.0, 1.0), mask.easing);
}

double line_value(const glm::dvec3& p, const TileMask& mask)
{
    const glm::dvec3 way = mask.end - mask.begin;
    if (!(glm::dot(way, way) > 0)) return 0;
    return eased(share_along(p, mask.begin, way), mask.easing);
}

// The axis along which a place is seen, and whether from its far side.
std::pair<int, bool> seen_along(MaskLies lies, const glm::dvec3& normal)
{
    switch (lies) {
    case MaskLies::along_x: return {0, false};
    case MaskLies::along_y: return {1, true}; // from the front
    case MaskLies::along_z:
    case MaskLies::uv: return {2, false};
    case MaskLies::from_six_sides: break;
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    return {axis, normal[axis] < 0};
}

// Where a place is in an image that is stretched over the box, right side up for who looks at it.
glm::dvec2 projected(const Box& box, const MaskPlace& place, MaskLies lies)
{
    const glm::dvec3 share = (place.p - glm::dvec3(box.lo)) / glm::max(box.size(), 1e-12);
    const auto [axis, far] = seen_along(lies, place.normal);
    switch (axis) {
    case 0: return {far ? 1 - share.y : share.y, share.z};
    case 1: return {far ? share.x : 1 - share.x, share.z};
    default: return {share.x, far ? 1 - share.y : share.y};
    }
}

std::optional<double> image_value(const ReadyMask& mask, const Box& box, const MaskPlace& place)
{
    if (!mask.image) return {};
    if (mask.mask.lies == MaskLies::uv && !place.uv) return {};
    const glm::dvec2 at =
        mask.mask.lies == MaskLies::uv ? *place.uv : projected(box, place, mask.mask.lies);
    const glm::dvec2 repeat(mask.mask.repeat_u, mask.mask.repeat_v),
        shift(mask.mask.shift_u, mask.mask.shift_v);
    return std::clamp(grey_at(*mask.image, repeat * at + shift, ImageEdge::repeat), 0.0, 1.0);
}

} // namespace

std::optional<double> mask_value(const ReadyMask& ready, const Box& box, const MaskPlace& place)
{
    const TileMask& mask = ready.mask;
    std::optional<double> value;
    if (mask.hidden) return value;
    switch (mask.from) {
    case MaskFrom::image: value = image_value(ready, box, place); break;
    case MaskFrom::line: value = line_value(place.p, mask); break;
    case MaskFrom::point: value = near_value(glm::distance(place.p, mask.begin), mask); break;
    case MaskFrom::curve:
        if (ready.curve) value = near_value(ready.curve->to(place.p), mask);
        break;
    }
    if (value && mask.inverted) value = 1 - *value;
    return value;
}

bool TileMasks::drive(MaskDrives what) const
{
    return std::ranges::any_of(
        all, [&](const ReadyMask& each) { return !each.mask.hidden && each.mask.drives == what; });
}

bool TileMasks::read_uvs() const
{
    return std::ranges::any_of(all, [](const ReadyMask& each) {
        return !each.mask.hidden && each.mask.from == MaskFrom::image && each.image &&
               each.mask.lies == MaskLies::uv;
    });
}

MaskFactors TileMasks::at(const MaskPlace& place) const
{
    MaskFactors out;
    for (const ReadyMask& each : all) {
        const std::optional<double> value = mask_value(each, box, place);
        if (!value) continue;
        const double factor = std::max(0.0, std::lerp(each.mask.low, each.mask.high, *value));
        switch (each.mask.drives) {
        case MaskDrives::density: out.density *= factor; break;
        case MaskDrives::scale: out.scale *= factor; break;
        case MaskDrives::height: out.height *= factor; break;
        case MaskDrives::morph: out.morph *= factor; break;
        }
    }
    return out;
}

bool is_there(std::uint32_t seed, double density)
{
    return random_share(seed, random_purpose::density) < density;
}

} // namespace trivar
