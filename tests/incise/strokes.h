// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/incise.h"

#include <random>

namespace trivar::testing {

// A hand that draws random strokes on a skin: straight on, with a curvature and a tremble.
class RandomHand {
public:
    RandomHand(const SlitSkin& skin, std::uint64_t seed) : skin_(skin), random_(seed) {}

    double number(double lo = 0, double hi = 1)
    {
        return std::uniform_real_distribution<double>(lo, hi)(random_);
    }
    SkinPlace place();
    SkinPlace at_point(std::uint32_t triangle) const { return {triangle, {1, 0, 0}}; }
    glm::dvec3 direction(std::uint32_t triangle); // unit, along the triangle
    // The direction turned counter-clockwise.
    glm::dvec3 turned(std::uint32_t triangle, const glm::dvec3& direction, double angle) const;
    // Moves a place over the skin, and turns the direction with it. False: over a border.
    bool move(SkinPlace& at, glm::dvec3& direction, double distance);

    struct Path {
        double length, curvature = 0, tremble = 0.05;
        double back = 0.5; // share of the length behind the place
    };
    // Empty where it would leave the skin.
    std::vector<SkinPlace> path(const SkinPlace& at, const glm::dvec3& direction, const Path& path);
    std::vector<SurfacePoint> stroke(const std::vector<SkinPlace>& path) const;
    glm::dvec3 position(const SkinPlace& at) const;

private:
    glm::dvec3 normal(std::uint32_t t) const { return glm::normalize(skin_.area_normal(t)); }
    const SlitSkin& skin_;
    std::mt19937_64 random_;
};

// The ten kinds of sets that cross on purpose.
inline constexpr std::array cut_kinds{"angle", "T",     "vertex", "parallel", "retrace",
                                      "twice", "three", "five",   "edges",    "depths"};
// Empty where the hand left the skin. With sizes in edges of the skin; many are unreasonable.
std::vector<Incision> random_set(const SlitSkin& skin, RandomHand& hand, std::size_t kind);
Incision random_single(const SlitSkin& skin, RandomHand& hand, bool loop);

} // namespace trivar::testing
