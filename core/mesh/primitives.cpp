// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"

#include "core/base/rejected.h"
#include "core/mesh/grid_mesh.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace trivar {
namespace {

void check_size(double value, const char* what)
{
    // The limits keep every coordinate and its square far inside a float.
    if (!(value >= 1e-9 && value <= 1e9))
        throw Rejected(fmt::format("the {} must be between 1e-9 and 1e9, not {}", what, value));
}

void check_count(int value, int least, int most, const char* what)
{
    if (value < least || value > most)
        throw Rejected(fmt::format("{} must be {} to {}, not {}", what, least, most, value));
}

// Returns point i of n on the unit circle; quarter points are exact, and i and n + i have the same
// bits.
glm::dvec2 on_circle(int i, int n)
{
    i %= n;
    if (i * 4 % n == 0) {
        const int quarter = i * 4 / n;
        return quarter == 0   ? glm::dvec2(1, 0)
               : quarter == 1 ? glm::dvec2(0, 1)
               : quarter == 2 ? glm::dvec2(-1, 0)
                              : glm::dvec2(0, -1);
    }
    const double angle = 2 * std::numbers::pi * i / n;
    return {std::cos(angle), std::sin(angle)};
}

// Returns value i of n from -size / 2 to size / 2, with mirrored bits.
double centred(double size, int i, int n)
{
    return size * (2 * i - n) / (2.0 * n);
}

// Adds the disk that closes a cylinder, in rings, so that it bends with the rest.
void append_cap(Mesh& mesh, double radius, double z, bool top, int segments)
{
    const int rings = std::max(1, segments / 8);
    const auto vertex_at = [&](int i, int j) {
        const double part = double(rings - j) / rings;
        const glm::dvec2 c = on_circle(i, segments) * part;
        const glm::dvec2 uv = 0.5 + 0.5 * c;
        return GridVertex{{c * radius, z}, {0, 0, top ? 1 : -1}, {top ? uv.x : 1 - uv.x, uv.y}};
    };
    append_grid(mesh, {segments, rings}, vertex_at, !top);
}

} // namespace

Mesh plane_mesh(glm::dvec2 size, glm::ivec2 segments)
{
    check_size(size.x, "width of the plane");
    check_size(size.y, "depth of the plane");
    for (int i = 0; i < 2; ++i) check_count(segments[i], 1, 2000, "segments of the plane");
    Mesh mesh;
    append_grid(mesh, segments, [&](int i, int j) {
        return GridVertex{{centred(size.x, i, segments.x), centred(size.y, j, segments.y), 0},
                          {0, 0, 1},
                          glm::dvec2(i, j) / glm::dvec2(segments)};
    });
    return mesh;
}

Mesh box_mesh(glm::dvec3 size, glm::ivec3 segments)
{
    for (int i = 0; i < 3; ++i) {
        check_size(size[i], "size of the box");
        check_count(segments[i], 1, 500, "segments of the box");
    }
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {1, -1}) {
            // These are the horizontal and the vertical axis of the side, seen from outside.
            const int a = axis == 2 ? 0 : (axis + (axis == 0 ? 1 : 2)) % 3, b = axis == 2 ? 1 : 2;
            const double mirror = (axis == 1 ? -1 : 1) * sign;
            append_grid(mesh, {segments[a], segments[b]}, [&](int i, int j) {
                const int across = mirror > 0 ? i : segments[a] - i;
                GridVertex vertex{glm::dvec3(0),
                                  glm::dvec3(0),
                                  {double(i) / segments[a], double(j) / segments[b]}};
                vertex.position[axis] = sign * size[axis] / 2;
                vertex.position[a] = centred(size[a], across, segments[a]);
                vertex.position[b] = centred(size[b], j, segments[b]);
                vertex.normal[axis] = sign;
                return vertex;
            });
        }
    return finished_grids(std::move(mesh));
}

Mesh sphere_mesh(double radius, int segments, int rings)
{
    check_size(radius, "radius of the sphere");
    check_count(segments, 3, 2000, "segments of the sphere");
    check_count(rings, 2, 1000, "rings of the sphere");
    Mesh mesh;
    append_grid(mesh, {segments, rings}, [&](int i, int j) {
        const bool pole = j == 0 || j == rings;
        // The triangle at a pole keeps its left corner at the south pole, its right one at the
        // north pole.
        const double middle = j == 0 ? 0.5 : j == rings ? -0.5 : 0;
        // The meridian is half of a circle of 2 rings steps, from the south pole on.
        const glm::dvec2 meridian = on_circle(j, 2 * rings);
        const glm::dvec2 around = on_circle(i, segments);
        const glm::dvec3 n(pole ? glm::dvec2(0) : around * meridian.y, -meridian.x);
        return GridVertex{n * radius, n, {(i + middle) / segments, double(j) / rings}};
    });
    return finished_grids(std::move(mesh));
}

Mesh cylinder_mesh(double radius, double height, int segments, int stacks)
{
    check_size(radius, "radius of the cylinder");
    check_size(height, "height of the cylinder");
    check_count(segments, 3, 2000, "segments of the cylinder");
    check_count(stacks, 1, 2000, "stacks of the cylinder");
    Mesh mesh;
    append_grid(mesh, {segments, stacks}, [&](int i, int j) {
        const glm::dvec2 c = on_circle(i, segments);
        return GridVertex{{c * radius, centred(height, j, stacks)},
                          {c, 0},
                          {double(i) / segments, double(j) / stacks}};
    });
    append_cap(mesh, radius, height / 2, true, segments);
    append_cap(mesh, radius, -height / 2, false, segments);
    return finished_grids(std::move(mesh));
}

Mesh torus_mesh(double radius, double tube, glm::ivec2 segments)
{
    check_size(radius, "radius of the torus");
    check_size(tube, "tube of the torus");
    if (tube >= radius)
        throw Rejected(fmt::format("the tube of the torus must be thinner than its radius {}, not "
                                   "{}",
                                   radius, tube));
    for (int i = 0; i < 2; ++i) check_count(segments[i], 3, 2000, "segments of the torus");
    Mesh mesh;
    append_grid(mesh, segments, [&](int i, int j) {
        const glm::dvec2 c = on_circle(i, segments.x), t = on_circle(j, segments.y);
        return GridVertex{{c * (radius + tube * t.x), tube * t.y},
                          {c * t.x, t.y},
                          glm::dvec2(i, j) / glm::dvec2(segments)};
    });
    return finished_grids(std::move(mesh));
}

Mesh moebius_mesh(double radius, double width, glm::ivec2 segments)
{
    check_size(radius, "radius of the Moebius band");
    check_size(width, "width of the Moebius band");
    if (width >= 2 * radius)
        throw Rejected(fmt::format("the Moebius band must be narrower than twice its radius {}, "
                                   "not {}",
                                   radius, width));
    check_count(segments.x, 3, 2000, "segments of the Moebius band");
    check_count(segments.y, 1, 2000, "segments of the Moebius band");
    Mesh mesh;
    append_grid(mesh, segments, [&](int i, int j) {
        // The band closes with a half turn: the last column is the first one upside down.
        const bool back = i == segments.x;
        const glm::dvec2 c = on_circle(i, segments.x),
                         half = on_circle(back ? 0 : i, 2 * segments.x);
        const double s = centred(width, back ? segments.y - j : j, segments.y);
        // p(t, s) = (radius + s cos(t / 2)) (cos t, sin t), s sin(t / 2); the normal is p_t x p_s.
        const double r = radius + s * half.x;
        const glm::dvec3 p_t(c.x * (-s * half.y / 2) - c.y * r, c.y * (-s * half.y / 2) + c.x * r,
                             s * half.x / 2);
        const glm::dvec3 p_s(c * half.x, half.y);
        const glm::dvec3 n = glm::normalize(glm::cross(p_t, p_s));
        return GridVertex{
            {c * r, s * half.y}, back ? -n : n, glm::dvec2(i, j) / glm::dvec2(segments)};
    });
    return finished_grids(std::move(mesh));
}

} // namespace trivar
