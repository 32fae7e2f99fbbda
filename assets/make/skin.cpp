// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/skin.h"

#include "assets/make/field.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>

namespace make {

void both(std::vector<Mesh>& v, const Mesh& m)
{
    v.push_back(m);
    v.push_back(mirrored(m));
}

Mesh cone(vec3 base, vec3 tip, float r, int mat, int n)
{
    Mesh m = tube({vec4(base, r), vec4(glm::mix(base, tip, .5f), r * .72f), vec4(tip, r * .16f)}, n,
                  false, 1);
    return m.mat(mat);
}

namespace {

// u is the angle; the corners of a face across the seam stay together, beyond 0..1.
void wrap(Mesh& mesh, const std::function<vec2(vec3)>& angle_and_height)
{
    mesh.uvs.clear();
    for (const Face& q : mesh.faces) {
        std::array<vec2, 4> uv{};
        for (std::size_t k = 0; k < corner_count(q); ++k) {
            uv[k] = angle_and_height(mesh.points[q[k]]);
            uv[k].x = uv[k].x / (2 * pi) + .5f;
            if (uv[k].x - uv[0].x > .5f) uv[k].x -= 1;
            if (uv[k].x - uv[0].x < -.5f) uv[k].x += 1;
        }
        mesh.uvs.push_back(uv);
    }
}

} // namespace

void wrap_about_x(Mesh& mesh, const std::function<float(float)>& center_y)
{
    wrap(mesh, [&](vec3 p) { return vec2(std::atan2(p.z, p.y - center_y(p.x)), p.x); });
}

void wrap_about_x(Mesh& mesh, float center_y)
{
    wrap_about_x(mesh, [=](float) { return center_y; });
}

void wrap_about_y(Mesh& mesh, vec2 axis_xz)
{
    float lo = 1e9f, hi = -1e9f;
    for (const vec3& p : mesh.points) {
        lo = std::min(lo, p.y);
        hi = std::max(hi, p.y);
    }
    wrap(mesh, [&](vec3 p) {
        return vec2(std::atan2(axis_xz.y - p.z, p.x - axis_xz.x), (p.y - lo) / (hi - lo));
    });
}

Mesh plain(Mesh m, int k)
{
    m.colors.clear();
    return m.mat(k);
}

} // namespace make
