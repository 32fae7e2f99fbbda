// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/object.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

// A Turn holds the cosine and sine of an angle, exact for quarter turns, so that a model turned by
// 90 degrees keeps the bits of its coordinates.
struct Turn {
    double cosine, sine;
};
Turn turn(double degrees)
{
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters) && std::abs(quarters) < 1e9) {
        static constexpr std::array<Turn, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const auto step = static_cast<long long>(quarters) % 4;
        return exact[static_cast<std::size_t>((step + 4) % 4)];
    }
    const double radians = glm::radians(degrees);
    return {std::cos(radians), std::sin(radians)};
}

} // namespace

glm::dmat4 Transform::matrix() const
{
    const auto [cx, sx] = turn(rotation_deg.x);
    const auto [cy, sy] = turn(rotation_deg.y);
    const auto [cz, sz] = turn(rotation_deg.z);
    // These are the columns of Rz Ry Rx.
    const glm::dvec3 x{cy * cz, cy * sz, -sy};
    const glm::dvec3 y{sx * sy * cz - cx * sz, sx * sy * sz + cx * cz, sx * cy};
    const glm::dvec3 z{cx * sy * cz + sx * sz, cx * sy * sz - sx * cz, cx * cy};
    return {glm::dvec4(x * scale.x, 0), glm::dvec4(y * scale.y, 0), glm::dvec4(z * scale.z, 0),
            glm::dvec4(translation, 1)};
}

} // namespace trivar
