// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// A Box is axis-aligned; it is empty when it is made.
struct Box {
    glm::dvec3 lo{1e300}, hi{-1e300};
    bool empty() const { return lo.x > hi.x; }
    glm::dvec3 size() const { return empty() ? glm::dvec3(0) : hi - lo; }
    glm::dvec3 center() const { return (lo + hi) / 2.0; }
    void add(const glm::dvec3& p)
    {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void add(const Box& other)
    {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    // Whether the two have no point in common. True where one is empty.
    bool apart(const Box& other) const
    {
        return glm::any(glm::greaterThan(lo, other.hi)) || glm::any(glm::lessThan(hi, other.lo));
    }
    std::array<glm::dvec3, 8> corners() const // meaningless for an empty box
    {
        return {{lo,
                 {hi.x, lo.y, lo.z},
                 {lo.x, hi.y, lo.z},
                 {hi.x, hi.y, lo.z},
                 {lo.x, lo.y, hi.z},
                 {hi.x, lo.y, hi.z},
                 {lo.x, hi.y, hi.z},
                 hi}};
    }
    double distance(const glm::dvec3& p) const // to the nearest point of the box; 0 inside
    {
        return glm::length(glm::max(glm::max(lo - p, p - hi), glm::dvec3(0)));
    }
};

} // namespace trivar
