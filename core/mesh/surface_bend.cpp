// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_bend.h"

#include "core/base/parallel.h"
#include "core/mesh/vertex_corners.h"

#include <cmath>

namespace trivar {
namespace {

// A TriangleBend is the bend of a triangle in its own frame, with the share of its area at each
// corner.
struct TriangleBend {
    glm::vec3 normal{0}, u{0}, v{0};
    glm::vec3 uu_uv_vv{0};
    glm::vec3 areas{0};
};

// The parts of a triangle that are nearest to its corners; of an obtuse one half of it at the
// obtuse corner [Meyer et al. 2003, 3.3]. `sides` are those opposite the corners.
glm::dvec3 mixed_areas(const std::array<glm::dvec3, 3>& sides, double area)
{
    glm::dvec3 cotangents;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        cotangents[i] = -glm::dot(sides[(k + 1) % 3], sides[(k + 2) % 3]) / (2 * area);
    }
    for (int i = 0; i < 3; ++i)
        if (cotangents[i] < 0) {
            glm::dvec3 out(area / 4);
            out[i] = area / 2;
            return out;
        }
    glm::dvec3 out;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto squared = [&](int side) {
            const glm::dvec3& s = sides[static_cast<std::size_t>(side)];
            return glm::dot(s, s);
        };
        out[i] = (squared(j) * cotangents[j] + squared(k) * cotangents[k]) / 8;
    }
    return out;
}

// [Rusinkiewicz 2004, (4) and (5)]: least squares of B e = dn over the three sides e.
TriangleBend bend_of_triangle(const std::array<glm::dvec3, 3>& p,
                              const std::array<glm::dvec3, 3>& n)
{
    TriangleBend out;
    const std::array<glm::dvec3, 3> sides{p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    const glm::dvec3 across = glm::cross(sides[1], sides[2]);
    const double twice = glm::length(across);
    if (!(twice > 0) || !(glm::length(sides[2]) > 0)) return out;
    const glm::dvec3 normal = across / twice, u = glm::normalize(sides[2]),
                     v = glm::cross(normal, u);
    glm::dmat3 w(0);
    glm::dvec3 m(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 dn = n[(i + 2) % 3] - n[(i + 1) % 3];
        const double a = glm::dot(sides[i], u), b = glm::dot(sides[i], v), dn_u = glm::dot(dn, u),
                     dn_v = glm::dot(dn, v);
        w[0][0] += a * a;
        w[0][1] += a * b;
        w[2][2] += b * b;
        m += glm::dvec3(dn_u * a, dn_u * b + dn_v * a, dn_v * b);
    }
    w[1][1] = w[0][0] + w[2][2];
    w[1][0] = w[1][2] = w[2][1] = w[0][1];
    const double scale = w[1][1];
    if (!(std::abs(glm::determinant(w)) > 1e-12 * scale * scale * scale)) return out;
    out.normal = glm::vec3(normal);
    out.u = glm::vec3(u);
    out.v = glm::vec3(v);
    out.uu_uv_vv = glm::vec3(glm::inverse(w) * m);
    out.areas = glm::vec3(mixed_areas(sides, twice / 2));
    return out;
}

// A vector turned as the shortest turn takes one unit vector to another.
glm::vec3 turned(const glm::vec3& d, const glm::vec3& from, const glm::vec3& to)
{
    const float cosine = glm::dot(from, to);
    if (cosine < -0.999f) return -d;
    const glm::vec3 axis = glm::cross(from, to);
    return cosine * d + glm::cross(axis, d) + glm::dot(axis, d) / (1 + cosine) * axis;
}

} // namespace

SurfaceBend bend_of(const glm::vec3& u, const glm::vec3& v, const glm::vec3& w)
{
    const auto entry = [&](int i, int j) {
        return w.x * u[i] * u[j] + w.y * (u[i] * v[j] + v[i] * u[j]) + w.z * v[i] * v[j];
    };
    return {{entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)}};
}

std::array<glm::vec3, 2> tangents_of(const glm::vec3& normal)
{
    const glm::vec3 size = glm::abs(normal);
    glm::vec3 axis(0);
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const glm::vec3 u = glm::normalize(glm::cross(normal, axis));
    return {u, glm::cross(normal, u)};
}

SurfaceBend in_tangent_plane(const SurfaceBend& bend, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return {};
    const auto [u, v] = tangents_of(normal);
    const glm::vec3 of_v = bend * v;
    return bend_of(u, v, {bend.along(u), glm::dot(u, of_v), glm::dot(v, of_v)});
}

PrincipalBend principal(const SurfaceBend& bend, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return {};
    const auto [u, v] = tangents_of(normal);
    const glm::vec3 of_v = bend * v;
    const float a = bend.along(u), b = glm::dot(u, of_v), c = glm::dot(v, of_v);
    const float half = std::sqrt((a - c) * (a - c) / 4 + b * b);
    PrincipalBend out{(a + c) / 2 + half, (a + c) / 2 - half, u};
    // The longer of the two rows of B - least gives the direction.
    const float on_u = a - out.least, on_v = c - out.least;
    const glm::vec2 d = on_u >= on_v ? glm::vec2(on_u, b) : glm::vec2(b, on_v);
    if (const float length = glm::length(d); length > 0)
        out.direction = (d.x * u + d.y * v) / length;
    return out;
}

std::vector<SurfaceBend> surface_bends(std::span<const glm::vec3> positions,
                                       std::span<const glm::vec3> normals,
                                       std::span<const std::uint32_t> corners)
{
    std::vector<TriangleBend> of_triangle(corners.size() / 3);
    parallel_blocks(of_triangle.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            std::array<glm::dvec3, 3> p, n;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = positions[corners[3 * t + k]];
                n[k] = normals[corners[3 * t + k]];
            }
            of_triangle[t] = bend_of_triangle(p, n);
        }
    });
    const VertexCorners round(corners, positions.size());
    std::vector<SurfaceBend> out(positions.size());
    parallel_blocks(out.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float area = 0;
            for (const std::uint32_t corner : round[i]) {
                const TriangleBend& from = of_triangle[corner / 3];
                const float share = from.areas[static_cast<int>(corner % 3)];
                const SurfaceBend part =
                    bend_of(turned(from.u, from.normal, normals[i]),
                            turned(from.v, from.normal, normals[i]), from.uu_uv_vv);
                for (std::size_t k = 0; k < 6; ++k) out[i].b[k] += share * part.b[k];
                area += share;
            }
            if (area > 0)
                for (float& each : out[i].b) each /= area;
        }
    });
    return out;
}

} // namespace trivar
