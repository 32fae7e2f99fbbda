// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/density.h"

namespace make {

namespace {
constexpr float tail_deviations = 3.6f; // deviations beyond which nothing is added
const float per_deviation = std::pow(2 * pi, -1.5f);
} // namespace

Density::Density(glm::ivec3 size, vec3 lo, float step)
    : size_(size),
      lo_(lo),
      step_(step),
      samples_(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
{
}

void Density::add(vec3 center, float electrons, float deviation)
{
    const float peak = electrons * per_deviation / (deviation * deviation * deviation);
    const glm::ivec3 begin = glm::max(
        glm::ivec3(0), glm::ivec3(glm::ceil((center - tail_deviations * deviation - lo_) / step_)));
    const glm::ivec3 end = glm::min(
        size_, glm::ivec3(glm::floor((center + tail_deviations * deviation - lo_) / step_)) + 1);
    std::array<std::vector<float>, 3> factors;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = begin[axis]; i < end[axis]; ++i) {
            const float d = (lo_[axis] + step_ * float(i) - center[axis]) / deviation;
            factors[std::size_t(axis)].push_back(std::exp(-.5f * d * d));
        }
    for (int z = begin.z; z < end.z; ++z)
        for (int y = begin.y; y < end.y; ++y) {
            const float of_row =
                peak * factors[1][std::size_t(y - begin.y)] * factors[2][std::size_t(z - begin.z)];
            float* row = &samples_[std::size_t(size_.x) *
                                   (std::size_t(y) + std::size_t(size_.y) * std::size_t(z))];
            for (int x = begin.x; x < end.x; ++x)
                row[x] += of_row * factors[0][std::size_t(x - begin.x)];
        }
}

// Five balls, whose sum has the deviation along the bond.
void Density::add_bond(vec3 a, vec3 b, float electrons, float along, float across)
{
    const vec3 middle = .5f * (a + b), d = glm::normalize(b - a);
    const float spread = std::sqrt(std::max(along * along - across * across, 0.f) / 2);
    for (int i = -2; i <= 2; ++i) {
        static constexpr float weights[]{.1f, .2f, .4f, .2f, .1f};
        add(middle + d * (1.29f * spread * float(i)), electrons * weights[i + 2], across);
    }
}

Volume Density::scaled(float factor) const
{
    Volume out{size_, step_, {}};
    out.samples.reserve(samples_.size());
    for (const float value : samples_)
        out.samples.push_back(std::int16_t(std::lround(std::clamp(factor * value, 0.f, 32767.f))));
    return out;
}

} // namespace make
