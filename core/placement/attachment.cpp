// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/attachment.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace trivar {
namespace {

using Symmetric4 = std::array<std::array<double, 4>, 4>;

// Finds the unit eigenvector of the largest eigenvalue by Jacobi rotations.
std::array<double, 4> leading_eigenvector(Symmetric4 a)
{
    Symmetric4 v{};
    for (std::size_t i = 0; i < 4; ++i) v[i][i] = 1;
    constexpr int sweeps = 24; // they converge quadratically
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t q = p + 1; q < 4; ++q) {
                if (a[p][q] == 0) continue;
                const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
                const double c = std::cos(angle), s = std::sin(angle);
                for (std::size_t k = 0; k < 4; ++k) {
                    const double x = a[k][p], y = a[k][q];
                    a[k][p] = c * x - s * y;
                    a[k][q] = s * x + c * y;
                }
                for (std::size_t k = 0; k < 4; ++k) {
                    const double x = a[p][k], y = a[q][k];
                    a[p][k] = c * x - s * y;
                    a[q][k] = s * x + c * y;
                }
                for (std::size_t k = 0; k < 4; ++k) {
                    const double x = v[k][p], y = v[k][q];
                    v[k][p] = c * x - s * y;
                    v[k][q] = s * x + c * y;
                }
            }
    std::size_t best = 0;
    for (std::size_t i = 1; i < 4; ++i)
        if (a[i][i] > a[best][best]) best = i;
    return {v[0][best], v[1][best], v[2][best], v[3][best]};
}

glm::dvec3 mean(const std::vector<glm::dvec3>& points)
{
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

} // namespace

glm::dmat4 AttachedHost::stood() const
{
    return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(origin, 1)};
}

AttachedHost attached_host(int object, const glm::dmat4& stood, bool touched)
{
    return {object,
            glm::dvec3(stood[0]),
            glm::dvec3(stood[1]),
            glm::dvec3(stood[2]),
            glm::dvec3(stood[3]),
            touched};
}

std::size_t main_host(const Attachment& attachment)
{
    std::vector<std::size_t> samples(attachment.hosts.size(), 0);
    for (const AttachedSample& each : attachment.samples)
        if (each.host >= 0) ++samples[static_cast<std::size_t>(each.host)];
    const auto most = std::ranges::max_element(samples);
    if (most != samples.end() && *most > 0) return static_cast<std::size_t>(most - samples.begin());
    const auto touched = std::ranges::find(attachment.hosts, true, &AttachedHost::touched);
    return touched == attachment.hosts.end()
               ? 0
               : static_cast<std::size_t>(touched - attachment.hosts.begin());
}

bool carries(const Attachment& attachment)
{
    const auto met = [](const AttachedSample& sample) { return sample.host >= 0; };
    return std::ranges::any_of(attachment.hosts, &AttachedHost::touched) ||
           std::ranges::any_of(attachment.samples, met);
}

std::optional<Attachment> renumbered(const Attachment& attachment,
                                     const std::function<std::optional<int>(int)>& number)
{
    Attachment out;
    std::vector<int> place; // of each host in the new list
    for (AttachedHost host : attachment.hosts) {
        const std::optional<int> object = number(host.object);
        place.push_back(object ? static_cast<int>(out.hosts.size()) : -1);
        if (!object) continue;
        host.object = *object;
        out.hosts.push_back(host);
    }
    if (out.hosts.empty()) return {};
    for (AttachedSample sample : attachment.samples) {
        if (sample.host >= 0 && sample.host < static_cast<int>(place.size()))
            sample.host = place[static_cast<std::size_t>(sample.host)];
        out.samples.push_back(sample.host >= 0 ? sample : AttachedSample{});
    }
    return out;
}

void check(const Attachment& attachment, std::size_t samples)
{
    if (attachment.hosts.empty()) throw Rejected("field \"attach\" names no host");
    for (const AttachedHost& host : attachment.hosts) {
        if (!(std::abs(glm::determinant(glm::dmat3(host.stood()))) > 1e-30))
            throw Rejected(
                fmt::format("field \"attach\": the axes of host {} span no space", host.object));
        if (std::ranges::count(attachment.hosts, host.object, &AttachedHost::object) > 1)
            throw Rejected(fmt::format("field \"attach\" names host {} twice", host.object));
    }
    if (!attachment.samples.empty() && attachment.samples.size() != samples)
        throw Rejected(fmt::format("field \"attach\" has {} samples but the stroke has {}",
                                   attachment.samples.size(), samples));
    for (const AttachedSample& sample : attachment.samples)
        if (sample.host < -1 || sample.host >= static_cast<int>(attachment.hosts.size()))
            throw Rejected(fmt::format("field \"attach\": a sample names host number {} of {}",
                                       sample.host, attachment.hosts.size()));
}

glm::dmat4 best_motion(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to)
{
    const glm::dvec3 a0 = mean(from), b0 = mean(to);
    glm::dmat3 m(0); // the sum of a b^T
    double spread_a = 0, spread_b = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const glm::dvec3 a = from[i] - a0, b = to[i] - b0;
        m += glm::outerProduct(a, b);
        spread_a += glm::dot(a, a);
        spread_b += glm::dot(b, b);
    }
    constexpr std::size_t enough = 3; // points that determine a rotation
    if (from.size() < enough || !(spread_a > 0 && spread_b > 0))
        return glm::translate(glm::dmat4(1), b0 - a0);
    m /= std::sqrt(spread_a) * std::sqrt(spread_b);
    const auto s = [&](int i, int j) { return m[j][i]; };
    const double xx = s(0, 0), yy = s(1, 1), zz = s(2, 2);
    const double x = s(1, 2) - s(2, 1), y = s(2, 0) - s(0, 2), z = s(0, 1) - s(1, 0);
    const double xy = s(0, 1) + s(1, 0), zx = s(2, 0) + s(0, 2), yz = s(1, 2) + s(2, 1);
    const std::array<double, 4> q = leading_eigenvector({{{xx + yy + zz, x, y, z},
                                                          {x, xx - yy - zz, xy, zx},
                                                          {y, xy, yy - xx - zz, yz},
                                                          {z, zx, yz, zz - xx - yy}}});
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(q[0], q[1], q[2], q[3])));
    glm::dmat4 out(turn);
    out[3] = glm::dvec4(b0 - turn * a0, 1);
    return out;
}

Camera carried(Camera camera, const glm::dmat4& by)
{
    const double scale = glm::length(glm::dvec3(by[0]));
    camera.eye = glm::dvec3(by * glm::dvec4(camera.eye, 1));
    camera.target = glm::dvec3(by * glm::dvec4(camera.target, 1));
    camera.up = glm::dmat3(by) * camera.up / scale;
    camera.height_world *= scale;
    return camera;
}

PlacementParameters carried(PlacementParameters parameters, const glm::dmat4& by)
{
    const double scale = glm::length(glm::dvec3(by[0]));
    parameters.width *= scale;
    parameters.height *= scale;
    parameters.clearance *= scale;
    return parameters;
}

std::optional<double> even_scale(const glm::dmat4& matrix)
{
    const glm::dmat3 m(matrix);
    const double volume = glm::determinant(m);
    if (!(volume > 0) || !std::isfinite(volume)) return {};
    const double square = (glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])) / 3;
    constexpr double rounding = 1e-9;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(glm::dot(m[i], m[j]) - (i == j ? square : 0)) <= rounding * square))
                return {};
    return std::sqrt(square);
}

} // namespace trivar
