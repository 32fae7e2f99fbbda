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

// cylindrical texture coordinates about the model's long axis, seam under the belly
void wrap_about_x(Mesh& m, float yc)
{
    m.uvs.clear();
    for (auto& q : m.faces) {
        std::array<vec2, 4> t{};
        float a0 = 0;
        for (int k = 0; k < 4; k++)
            if (q[k] >= 0) {
                vec3 p = m.points[q[k]];
                float a = std::atan2(p.z, p.y - yc) / 6.2831853f + .5f;
                if (!k) a0 = a;
                if (a - a0 > .5f) a -= 1;
                if (a - a0 < -.5f) a += 1;
                t[k] = {a, p.x};
            }
        m.uvs.push_back(t);
    }
}

void wrap_about_y(Mesh& m, vec2 axis)
{ // cylindrical texture coordinates about +y, seam at the back
    m.uvs.clear();
    float lo = 1e9f, hi = -1e9f;
    for (auto& q : m.points) {
        lo = std::min(lo, q.y);
        hi = std::max(hi, q.y);
    }
    for (auto& q : m.faces) {
        std::array<vec2, 4> t{};
        float a0 = 0;
        for (int k = 0; k < 4; k++)
            if (q[k] >= 0) {
                vec3 p = m.points[q[k]];
                float a = std::atan2(-(p.z - axis.y), p.x - axis.x) / (2 * pi) + .5f;
                if (!k) a0 = a;
                if (a - a0 > .5f) a -= 1;
                if (a - a0 < -.5f) a += 1;
                t[k] = {a, (p.y - lo) / (hi - lo)};
            }
        m.uvs.push_back(t);
    }
}

Mesh plain(Mesh m, int k)
{
    m.colors.clear();
    return m.mat(k);
}

} // namespace make
