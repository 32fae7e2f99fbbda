// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/depth_pyramid.h"

#include <algorithm>

namespace trivar::gpu {
namespace {

constexpr int most_compared = 4; // that a box is compared with, along each side of the picture

} // namespace

DepthPyramid::DepthPyramid(std::vector<float> depths, glm::ivec2 size_px)
{
    levels_.push_back({size_px, std::move(depths)});
    while (glm::any(glm::greaterThan(levels_.back().size_px, glm::ivec2(1)))) {
        const Level& fine = levels_.back();
        Level coarse{(fine.size_px + 1) / 2, {}};
        const glm::ivec2 last = fine.size_px - 1;
        for (int y = 0; y < coarse.size_px.y; ++y)
            for (int x = 0; x < coarse.size_px.x; ++x) {
                const glm::ivec2 lo = 2 * glm::ivec2(x, y), hi = glm::min(lo + 1, last);
                coarse.depths.push_back(std::max(
                    {fine.at(lo), fine.at({hi.x, lo.y}), fine.at({lo.x, hi.y}), fine.at(hi)}));
            }
        levels_.push_back(std::move(coarse));
    }
}

bool DepthPyramid::hides(const Box& box, const glm::dmat4& to_clip) const
{
    if (levels_.empty() || box.empty()) return false;
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const glm::dvec3& corner : box.corners()) {
        const glm::dvec4 p = to_clip * glm::dvec4(corner, 1);
        if (!(p.w > 0)) return false;
        const glm::dvec3 there = 0.5 * glm::dvec3(p) / p.w + 0.5;
        lo = glm::min(lo, there);
        hi = glm::max(hi, there);
    }
    const glm::dvec2 size(levels_.front().size_px), most = size - 1.0;
    if (hi.x < 0 || hi.y < 0 || lo.x > 1 || lo.y > 1) return true; // it is beside the picture
    const glm::ivec2 first(glm::clamp(glm::dvec2(lo) * size - 1.0, glm::dvec2(0), most)),
        last(glm::clamp(glm::dvec2(hi) * size + 1.0, glm::dvec2(0), most));
    std::size_t n = 0;
    while (glm::any(glm::greaterThanEqual(
        (last >> static_cast<int>(n)) - (first >> static_cast<int>(n)), glm::ivec2(most_compared))))
        ++n;
    const int shift = static_cast<int>(n);
    // Single precision of the depths, and of the way to them.
    const double nearest = lo.z - 1e-6;
    for (int y = first.y >> shift; y <= last.y >> shift; ++y)
        for (int x = first.x >> shift; x <= last.x >> shift; ++x)
            if (!(levels_[n].at({x, y}) < nearest)) return false;
    return true;
}

} // namespace trivar::gpu
