// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/outline.h"
#include "assets/make/volumes/jaw_parts.h"

namespace make {

JawArch::JawArch()
{
    const std::vector<vec2> plan{{-8, 7},     {0, 6},      {8, 7},      {16, 11},  {23, 18},
                                 {29, 27},    {33.5f, 37}, {37.5f, 48}, {41, 59},  {44, 70},
                                 {46.5f, 80}, {48.5f, 90}, {50, 100},   {51, 110}, {52, 125}};
    points_ = smooth_loop(plan, 4, false);
    float length = 0, middle = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (i > 0) length += glm::distance(points_[i], points_[i - 1]);
        lengths_.push_back(length);
        if (std::abs(points_[i].x) < 1e-3f) middle = length;
    }
    for (float& each : lengths_) each -= middle;
}

vec2 JawArch::unrolled(vec2 p) const
{
    float best = 1e30f;
    vec2 out(0);
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const vec2 d = points_[i + 1] - points_[i], w = p - points_[i];
        const float t = saturate(glm::dot(w, d) / glm::dot(d, d));
        const vec2 off = w - d * t;
        const float far = glm::dot(off, off);
        if (far >= best) continue;
        best = far;
        out = {mix(lengths_[i], lengths_[i + 1], t),
               std::sqrt(far) * (d.x * w.y - d.y * w.x > 0 ? -1.f : 1.f)};
    }
    return out;
}

vec3 JawArch::at(float along, float outside, float z) const
{
    std::size_t i = 0;
    while (i + 2 < points_.size() && lengths_[i + 1] < along) ++i;
    const float t = (along - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
    const vec2 d = tangent(along), p = glm::mix(points_[i], points_[i + 1], t);
    return {p + outside * vec2(d.y, -d.x), z};
}

vec2 JawArch::tangent(float along) const
{
    std::size_t i = 0;
    while (i + 2 < points_.size() && lengths_[i + 1] < along) ++i;
    const auto middle = [&](std::size_t k) { return .5f * (lengths_[k] + lengths_[k + 1]); };
    const auto chord = [&](std::size_t k) { return glm::normalize(points_[k + 1] - points_[k]); };
    const std::size_t a = along < middle(i) && i > 0 ? i - 1 : i,
                      b = std::min(a + 1, points_.size() - 2);
    const float t = a == b ? 0 : saturate((along - middle(a)) / (middle(b) - middle(a)));
    return glm::normalize(glm::mix(chord(a), chord(b), t));
}

} // namespace make
