// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/studio.h"

#include "core/base/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar::gpu {
namespace {

constexpr double pi = std::numbers::pi;

Studio::Box placed(const Softbox& box, double azimuth, double elevation)
{
    const glm::dvec3 d(std::cos(azimuth) * std::cos(elevation),
                       std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
    const glm::dvec3 right(-std::sin(azimuth), std::cos(azimuth), 0);
    return {d, right, glm::cross(d, right), box.half_size, box.radiance, box.softness};
}

// The C(x) of studio.glsl for a mirror (alpha 0).
double lobe_step(double x, double s)
{
    return x / std::sqrt(x * x + s * s);
}

double softbox(const Studio::Box& box, const glm::dvec3& r)
{
    const double d = glm::dot(r, glm::dvec3(box.direction));
    const double k = 1 / std::max(d, 0.08);
    double product = 0.25 * smooth_step((d + 0.1) / (0.25 + 0.1));
    for (int axis = 0; axis < 2; ++axis) {
        const double p = glm::dot(r, glm::dvec3(axis ? box.up : box.right)) * k;
        const double s = box.softness * (1 + p * p), h = box.half_size[axis];
        product *= lobe_step(p + h, s) - lobe_step(p - h, s);
    }
    return product;
}

glm::dvec3 dome(const Studio& studio, const glm::dvec3& r)
{
    const double w = 0.3, q = r.z / w, b = 1 / std::sqrt(1 + q * q), t = 0.5 + 0.5 * q * b;
    return glm::mix(glm::dvec3(studio.floor), glm::dvec3(studio.zenith), t) +
           glm::dvec3(studio.horizon) * (0.3 / w * b * b * b);
}

} // namespace

Studio studio_for(const Look& look, double sun_azimuth, double sun_elevation, bool ground)
{
    Studio studio;
    for (std::size_t i = 0; i < 3; ++i) {
        const Softbox& box = look.boxes[i];
        studio.boxes[i] = placed(box, sun_azimuth + box.azimuth, i ? box.elevation : sun_elevation);
    }
    studio.zenith = look.zenith;
    studio.horizon = look.horizon;
    studio.floor = look.floor * (ground ? 1.0f : 0.55f);

    // Band 0 to 2 of the radiance over a Fibonacci sphere, convolved with the clamped cosine
    // (Ramamoorthi and Hanrahan 2001: pi, 2 pi / 3, pi / 4).
    constexpr int count = 20000;
    std::array<glm::dvec3, 9> sums{};
    glm::dvec3 key(0);
    const double weight = 4 * pi / count;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - z * z);
        const double a = 2.399963229728653 * i;
        const glm::dvec3 d(r * std::cos(a), r * std::sin(a), z);
        const glm::dvec3 light =
            dome(studio, d) + glm::dvec3(studio.boxes[1].radiance) * softbox(studio.boxes[1], d) +
            glm::dvec3(studio.boxes[2].radiance) * softbox(studio.boxes[2], d);
        const std::array<double, 9> basis{1,
                                          d.y,
                                          d.z,
                                          d.x,
                                          d.x * d.y,
                                          d.y * d.z,
                                          3 * z * z - 1,
                                          d.x * d.z,
                                          d.x * d.x - d.y * d.y};
        for (std::size_t k = 0; k < 9; ++k) sums[k] += light * (basis[k] * weight);
        const double facing = std::max(0.0, glm::dot(d, glm::dvec3(studio.boxes[0].direction)));
        key +=
            glm::dvec3(studio.boxes[0].radiance) * (softbox(studio.boxes[0], d) * facing * weight);
    }
    constexpr std::array<double, 9> norm{0.282095, 0.488603, 0.488603, 0.488603, 1.092548,
                                         1.092548, 0.315392, 1.092548, 0.546274};
    for (std::size_t k = 0; k < 9; ++k) {
        const double cosine = k == 0 ? pi : k < 4 ? 2 * pi / 3 : pi / 4;
        studio.ambient[k] = sums[k] * (norm[k] * norm[k] * cosine);
    }
    studio.key_irradiance = key;
    return studio;
}

} // namespace trivar::gpu
