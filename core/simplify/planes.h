// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace trivar {

// A weighted sum of planes as one quadric: of a point, the sum of its squared distances from them.
//   [1] Garland, Heckbert, Surface simplification using quadric error metrics, 1997
class Planes {
public:
    void add(const glm::dvec3& unit_normal, const glm::dvec3& p, double weight)
    {
        const glm::dvec3 n = weight * unit_normal;
        const double offset = -glm::dot(unit_normal, p);
        diagonal_ += n * unit_normal;
        mixed_ += glm::dvec3(n.x * unit_normal.y, n.y * unit_normal.z, n.z * unit_normal.x);
        linear_ += offset * n;
        constant_ += weight * offset * offset;
        weight_ += weight;
    }
    void add(const Planes& other)
    {
        diagonal_ += other.diagonal_;
        mixed_ += other.mixed_;
        linear_ += other.linear_;
        constant_ += other.constant_;
        weight_ += other.weight_;
    }
    double weight() const { return weight_; }
    double at(const glm::dvec3& p) const
    {
        const glm::dvec3 products(p.x * p.y, p.y * p.z, p.z * p.x);
        return std::max(0.0, glm::dot(diagonal_, p * p) +
                                 2 * (glm::dot(mixed_, products) + glm::dot(linear_, p)) +
                                 constant_);
    }

private:
    glm::dvec3 diagonal_{0}, mixed_{0}, linear_{0}; // of the symmetric matrix: xx yy zz, xy yz zx
    double constant_ = 0, weight_ = 0;
};

} // namespace trivar
