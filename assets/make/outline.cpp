// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/outline.h"

#include "assets/make/field.h"

#include <algorithm>
#include <cmath>

namespace make {

float polygon(vec2 p, const std::vector<vec2>& v)
{
    float d = 1e30f, s = 1;
    size_t n = v.size();
    for (size_t i = 0, j = n - 1; i < n; j = i++) {
        vec2 e = v[j] - v[i], w = p - v[i], b = w - e * saturate(glm::dot(w, e) / glm::dot(e, e));
        d = std::min(d, glm::dot(b, b));
        bool a = p.y >= v[i].y, c = p.y<v[j].y, g = e.x * w.y> e.y * w.x;
        if ((a && c && g) || (!a && !c && !g)) s = -s;
    }
    return s * std::sqrt(d);
}

float path_distance(vec2 p, const std::vector<vec2>& c)
{
    float d = 1e9f;
    for (size_t i = 0; i + 1 < c.size(); i++) {
        vec2 e = c[i + 1] - c[i], w = p - c[i];
        d = std::min(d, glm::length(w - e * saturate(glm::dot(w, e) / glm::dot(e, e))));
    }
    return d;
}

std::vector<vec2> fillet(const std::vector<vec2>& v, float r, int n, bool closed)
{
    std::vector<vec2> o;
    int N = int(v.size());
    for (int i = 0; i < N; i++) {
        if (!closed && (i == 0 || i == N - 1)) {
            o.push_back(v[i]);
            continue;
        }
        vec2 a = v[(i + N - 1) % N], b = v[i], c = v[(i + 1) % N];
        float la = glm::distance(a, b), lc = glm::distance(b, c),
              t = std::min({r, la * .45f, lc * .45f});
        vec2 p = b + (a - b) * (t / la), q = b + (c - b) * (t / lc);
        for (int k = 0; k <= n; k++) {
            float s = float(k) / n;
            o.push_back((1 - s) * (1 - s) * p + 2 * s * (1 - s) * b + s * s * q);
        }
    }
    return o;
}

std::vector<vec2> smooth_loop(const std::vector<vec2>& v, int n, bool closed)
{
    std::vector<vec2> o;
    int N = int(v.size());
    for (int i = 0; i < (closed ? N : N - 1); i++) {
        auto at = [&](int k) { return closed ? v[(k + N) % N] : v[std::clamp(k, 0, N - 1)]; };
        vec2 a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        for (int k = 0; k < n; k++) {
            float t = float(k) / n;
            o.push_back(.5f * (2.f * b + t * (c - a) + t * t * (2.f * a - 5.f * b + 4.f * c - d) +
                               t * t * t * (3.f * b - a - 3.f * c + d)));
        }
    }
    if (!closed) o.push_back(v.back());
    return o;
}

} // namespace make
