// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A SurfaceBend tells how a surface bends at a point: on a step d along the surface its unit normal
// turns by B d. B is symmetric, and B n = 0. Where the surface is convex, seen from the side to
// which the normal points, values are above 0. Per unit of length.
struct SurfaceBend {
    std::array<float, 6> b{}; // xx yy zz xy xz yz
    glm::vec3 operator*(const glm::vec3& d) const
    {
        return {b[0] * d.x + b[3] * d.y + b[4] * d.z, b[3] * d.x + b[1] * d.y + b[5] * d.z,
                b[4] * d.x + b[5] * d.y + b[2] * d.z};
    }
    // <d, B d>: the normal curvature along a unit direction.
    float along(const glm::vec3& d) const { return glm::dot(d, *this * d); }
    // Half the sum and the product of the principal curvatures.
    float mean() const { return (b[0] + b[1] + b[2]) / 2; }
    float gauss() const
    {
        return b[0] * b[1] + b[1] * b[2] + b[0] * b[2] - b[3] * b[3] - b[4] * b[4] - b[5] * b[5];
    }
};

inline SurfaceBend operator*(float factor, SurfaceBend bend)
{
    for (float& each : bend.b) each *= factor;
    return bend;
}

// B made of three numbers in a frame of the tangent plane: uu, uv and vv.
SurfaceBend bend_of(const glm::vec3& u, const glm::vec3& v, const glm::vec3& uu_uv_vv);
// Projects B into the tangent plane of a unit normal.
SurfaceBend in_tangent_plane(const SurfaceBend& bend, const glm::vec3& normal);

// The principal curvatures, and the unit direction of the greatest; its sign means nothing.
struct PrincipalBend {
    float greatest = 0, least = 0;
    glm::vec3 direction{0};
};
PrincipalBend principal(const SurfaceBend& bend, const glm::vec3& normal);

// Two unit vectors that make a right-handed frame with a unit normal.
std::array<glm::vec3, 2> tangents_of(const glm::vec3& normal);

// The bend at each vertex of a triangle mesh with unit normals: in each triangle the one that fits
// the differences of the normals along its sides best, turned into the tangent planes of its
// corners and averaged there by mixed areas [Rusinkiewicz 2004; Meyer et al. 2003]. 0 where no
// triangle is. 0.2 us per triangle; the same for any number of threads.
std::vector<SurfaceBend> surface_bends(std::span<const glm::vec3> positions,
                                       std::span<const glm::vec3> normals,
                                       std::span<const std::uint32_t> corners);

} // namespace trivar
