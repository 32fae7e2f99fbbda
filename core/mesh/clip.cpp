// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/clip.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

glm::dquat rotation(const std::vector<double>& xyzw)
{
    const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = glm::length(q);
    return length > least_rotation ? q / length : glm::dquat(1, 0, 0, 0);
}

std::vector<double> as_values(const glm::dquat& q)
{
    return {q.x, q.y, q.z, q.w};
}

} // namespace

glm::dmat4 NodeTransform::matrix() const
{
    const glm::dmat4 turned = glm::translate(glm::dmat4(1), translation) * glm::mat4_cast(rotation);
    return glm::scale(turned, scale);
}

std::vector<double> value_at(const Channel& channel, double time_s)
{
    const bool cubic = channel.interpolation == Channel::Interpolation::cubic;
    const bool turns = channel.of == Channel::Of::rotation;
    // Returns a part of a key; for a cubic one 0 is the in-tangent, 1 the value, 2 the out-tangent.
    const auto part = [&](std::size_t key, std::size_t which) {
        const std::size_t n = channel.components;
        const std::size_t at = (cubic ? 3 * key + which : key) * n;
        const auto first = channel.values.begin() + static_cast<std::ptrdiff_t>(at);
        return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(n));
    };
    const auto value = [&](std::size_t key) {
        return turns && !cubic ? as_values(rotation(part(key, 1))) : part(key, 1);
    };
    const auto unit = [&](std::vector<double> v) {
        return turns ? as_values(rotation(v)) : std::move(v);
    };
    const std::vector<float>& times = channel.times_s;
    const auto after = std::upper_bound(times.begin(), times.end(), time_s);
    if (after == times.begin()) return unit(value(0));
    const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end() || channel.interpolation == Channel::Interpolation::step)
        return unit(value(key));
    const double span = static_cast<double>(times[key + 1]) - static_cast<double>(times[key]);
    const double t = (time_s - static_cast<double>(times[key])) / span;
    std::vector<double> a = value(key), b = value(key + 1);
    if (cubic) {
        const std::vector<double> out = part(key, 2), in = part(key + 1, 0);
        const double t2 = t * t, t3 = t2 * t;
        for (std::size_t i = 0; i < a.size(); ++i)
            a[i] = (2 * t3 - 3 * t2 + 1) * a[i] + span * (t3 - 2 * t2 + t) * out[i] +
                   (3 * t2 - 2 * t3) * b[i] + span * (t3 - t2) * in[i];
        return unit(std::move(a));
    }
    if (turns) return as_values(glm::normalize(glm::slerp(rotation(a), rotation(b), t)));
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += t * (b[i] - a[i]);
    return a;
}

} // namespace trivar
