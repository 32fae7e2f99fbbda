// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/loft.h"

#include "assets/make/field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace make {

Curve::Curve(std::vector<vec2> keys) : keys_(std::move(keys)), slopes_(keys_.size(), 0)
{
    int n = int(keys_.size());
    std::vector<float> s(std::max(0, n - 1));
    for (int i = 0; i + 1 < n; i++)
        s[i] = (keys_[i + 1].y - keys_[i].y) / (keys_[i + 1].x - keys_[i].x);
    for (int i = 1; i + 1 < n; i++)
        if (s[i - 1] * s[i] > 0) {
            float a = keys_[i].x - keys_[i - 1].x, b = keys_[i + 1].x - keys_[i].x;
            slopes_[i] = 3 * (a + b) / ((2 * b + a) / s[i - 1] + (b + 2 * a) / s[i]);
        }
    if (n > 1) {
        slopes_[0] = s[0];
        slopes_[n - 1] = s[n - 2];
    }
}

float Curve::operator()(float x) const
{
    if (x <= keys_.front().x) return keys_.front().y;
    if (x >= keys_.back().x) return keys_.back().y;
    size_t i = 1;
    while (keys_[i].x < x) i++;
    float w = keys_[i].x - keys_[i - 1].x, t = (x - keys_[i - 1].x) / w, u = 1 - t;
    return u * u * (1 + 2 * t) * keys_[i - 1].y + t * t * (3 - 2 * t) * keys_[i].y +
           w * t * u * (u * slopes_[i - 1] - t * slopes_[i]);
}

Loft::Loft(const std::vector<Station>& k) : begin_(k.front().x), end_(k.back().x)
{
    std::vector<vec2> v[5];
    for (auto& e : k) {
        float c[5] = {e.y, e.w, e.up, e.down, e.squareness};
        for (int i = 0; i < 5; i++) v[i].push_back({e.x, c[i]});
    }
    y_ = v[0];
    width_ = v[1];
    up_ = v[2];
    down_ = v[3];
    squareness_ = v[4];
}

float Loft::level(float x, float e, float v, float z) const
{
    float W = width_(x), Y = v - y_(x), H = Y > 0 ? up_(x) : down_(x), N = squareness_(x),
          R = std::min(W, std::min(up_(x), down_(x)));
    float s = std::pow(std::pow(std::abs(z) / W, N) + std::pow(std::abs(Y) / H, N), 1 / N);
    return std::sqrt(s * s + e * e / (R * R));
}

float Loft::operator()(vec3 p) const
{ // (q - 1) over its gradient within the station: smooth in x, also past the ends
    float x = std::clamp(p.x, begin_, end_), t = p.x - x,
          H = std::max({width_(x), up_(x), down_(x)}),
          far = std::max({std::abs(p.y - y_(x)) - H, std::abs(p.z) - H, std::abs(t) - H});
    if (far > .25f) return far;
    float e = std::min({width_(x), up_(x), down_(x)}) * .02f + 1e-5f, v = level(x, t, p.y, p.z) - 1;
    vec3 g(level(x, t + e, p.y, p.z) - level(x, t - e, p.y, p.z),
           level(x, t, p.y + e, p.z) - level(x, t, p.y - e, p.z),
           level(x, t, p.y, p.z + e) - level(x, t, p.y, p.z - e));
    return std::max(v / (glm::length(g) / (2 * e) + 1e-6f), -H);
}

Limb::Limb(const std::vector<vec4>& k, int n)
{
    int N = int(k.size());
    lo_ = vec3(1e9f);
    hi_ = vec3(-1e9f);
    widest_ = 0;
    for (int i = 0; i + 1 < N; i++) {
        vec4 b = k[i], c = k[i + 1], a = i ? k[i - 1] : 2.f * b - c,
             d = i + 2 < N ? k[i + 2] : 2.f * c - b;
        int m = N == 2 ? 1 : n;
        for (int j = 0; j < m; j++) {
            float t = float(j) / m;
            vec4 q = .5f * (2.f * b + t * (c - a) + t * t * (2.f * a - 5.f * b + 4.f * c - d) +
                            t * t * t * (3.f * b - a - 3.f * c + d));
            q.w = std::max(q.w, std::min(b.w, c.w));
            spine_.push_back(q);
        }
    }
    spine_.push_back(k.back());
    for (auto& q : spine_) {
        lo_ = glm::min(lo_, vec3(q));
        hi_ = glm::max(hi_, vec3(q));
        widest_ = std::max(widest_, q.w);
    }
}

float Limb::operator()(vec3 p) const
{
    float far = glm::length(p - glm::clamp(p, lo_, hi_)) - widest_;
    if (far > .1f) return far;
    float d = 1e9f;
    for (size_t i = 0; i + 1 < spine_.size(); i++)
        d = std::min(
            d, capsule(p, vec3(spine_[i]), vec3(spine_[i + 1]), spine_[i].w, spine_[i + 1].w));
    return d;
}

} // namespace make
