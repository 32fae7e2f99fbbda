// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/cut_side.h"

#include <algorithm>

namespace trivar {
namespace {

// Bounds of the surface's u over a rectangle of (v, w).
struct Heights {
    double lo = 0, hi = 0;
};
Heights heights_over(const CutSheet& sheet, const glm::dvec2& lo, const glm::dvec2& hi)
{
    if (sheet.is_flat()) return {};
    const glm::dvec2 beside(hi.x, lo.y), over(lo.x, hi.y);
    const auto [least, most] =
        std::minmax({sheet.phi(lo), sheet.phi(hi), sheet.phi(beside), sheet.phi(over)});
    // Over a triangle a function is off from the linear one by at most 1/6 of its greatest bend
    double off = 0;
    for (const std::array<glm::dvec2, 3>& half : {std::array{lo, beside, hi}, {lo, hi, over}})
        off = std::max(off, std::ranges::max(sheet.bends(half)) / 6);
    return {least - off, most + off};
}

} // namespace

std::optional<bool> side_of(const Box& box, const CutSheet& sheet)
{
    if (box.empty()) return std::nullopt;
    Box there; // (u, v, w)
    for (const glm::dvec3& corner : box.corners()) there.add(sheet.uvw(corner));
    const Heights surface = heights_over(sheet, {there.lo.y, there.lo.z}, {there.hi.y, there.hi.z});
    if (there.lo.x >= surface.hi) return true;
    if (there.hi.x < surface.lo) return false;
    return std::nullopt;
}

} // namespace trivar
