// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_surface.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// `faces` tells which of the six at the low and the high end of each axis.
void add_box(VolumeSurface& out, const Lattice& volume, const glm::dvec3& lo, const glm::dvec3& hi,
             const std::array<int, 3>& steps, auto&& faces)
{
    for (std::size_t across = 0; across < 3; ++across) {
        const std::size_t s = (across + 1) % 3, t = (across + 2) % 3;
        for (const bool end : {false, true}) {
            if (!faces(static_cast<int>(across), end)) continue;
            const auto first = static_cast<std::uint32_t>(out.points.size());
            const auto row = static_cast<std::uint32_t>(steps[t] + 1);
            for (int i = 0; i <= steps[s]; ++i)
                for (int j = 0; j <= steps[t]; ++j) {
                    glm::dvec3 at(0);
                    at[static_cast<int>(across)] = end ? 1 : 0;
                    at[static_cast<int>(s)] = static_cast<double>(i) / steps[s];
                    at[static_cast<int>(t)] = static_cast<double>(j) / steps[t];
                    out.uvw.push_back(lo + at * (hi - lo));
                    out.points.push_back(evaluate(volume, out.uvw.back()).value);
                    if (i == 0 || j == 0) continue;
                    const std::uint32_t d =
                        first + static_cast<std::uint32_t>(i) * row + static_cast<std::uint32_t>(j);
                    const std::uint32_t a = d - row - 1, b = d - 1, c = d - row; // b: i, c: j
                    if (end)
                        out.triangles.insert(out.triangles.end(), {a, b, d, a, d, c});
                    else
                        out.triangles.insert(out.triangles.end(), {a, d, b, a, c, d});
                }
        }
    }
}

bool all_faces(int, bool)
{
    return true;
}

VolumeSurface cells_surface(const Lattice& volume, const CellVerdicts& verdicts, Verdict of)
{
    VolumeSurface out;
    const glm::ivec3 n = verdicts.size();
    constexpr auto few = 4000;
    const bool many = std::ranges::count(verdicts.of, of) > few,
               outside = many || of == Verdict::excepted;
    const std::array steps = many ? std::array{1, 1, 1} : std::array{3, 3, 3};
    const auto is = [&](const glm::ivec3& span) {
        return verdicts.of[static_cast<std::size_t>((span.x * n.y + span.y) * n.z + span.z)] == of;
    };
    for (glm::ivec3 span(0); span.x < n.x; ++span.x)
        for (span.y = 0; span.y < n.y; ++span.y)
            for (span.z = 0; span.z < n.z; ++span.z) {
                if (!is(span)) continue;
                glm::dvec3 lo, hi;
                for (int a = 0; a < 3; ++a) {
                    const auto& breaks = verdicts.breaks[static_cast<std::size_t>(a)];
                    lo[a] = breaks[static_cast<std::size_t>(span[a])];
                    hi[a] = breaks[static_cast<std::size_t>(span[a] + 1)];
                }
                add_box(out, volume, lo, hi, steps, [&](int axis, bool end) {
                    if (!outside) return true;
                    glm::ivec3 next = span;
                    next[axis] += end ? 1 : -1;
                    return next[axis] < 0 || next[axis] >= n[axis] || !is(next);
                });
            }
    return out;
}

} // namespace

VolumeSurface volume_surface(const Lattice& volume)
{
    VolumeSurface out;
    add_box(out, volume, glm::dvec3(0), glm::dvec3(1), {96, 12, 8}, all_faces);
    return out;
}

FoldSurfaces fold_surfaces(const Lattice& volume, const CellVerdicts& verdicts)
{
    return {cells_surface(volume, verdicts, Verdict::proven_bad),
            cells_surface(volume, verdicts, Verdict::unknown),
            cells_surface(volume, verdicts, Verdict::excepted)};
}

VolumeSurface slice_at(const Lattice& volume, double u)
{
    const std::vector<double> breaks = volume.displacement.axes[0].breaks();
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, u);
    const double lo = above - 1 == breaks.begin() ? breaks.front() : *(above - 2);
    const double hi = above + 1 == breaks.end() ? breaks.back() : *(above + 1);
    VolumeSurface out;
    add_box(out, volume, {lo, 0, 0}, {hi, 1, 1}, {8, 12, 8}, all_faces);
    return out;
}

std::optional<OnVolume> on_volume(const VolumeSurface& surface, const Ray& ray)
{
    std::optional<OnVolume> nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t + 2 < surface.triangles.size(); t += 3) {
        const std::uint32_t a = surface.triangles[t], b = surface.triangles[t + 1],
                            c = surface.triangles[t + 2];
        // Moeller and Trumbore 1997.
        const glm::dvec3 e1 = surface.points[b] - surface.points[a],
                         e2 = surface.points[c] - surface.points[a];
        const glm::dvec3 p = glm::cross(ray.direction, e2);
        const double det = glm::dot(e1, p);
        if (det == 0) continue;
        const glm::dvec3 s = (ray.origin - surface.points[a]) / det;
        const double x = glm::dot(s, p);
        const glm::dvec3 q = glm::cross(s, e1);
        const double y = glm::dot(ray.direction, q), far = glm::dot(e2, q);
        if (!(x >= 0 && y >= 0 && x + y <= 1 && far > 0 && far < distance)) continue;
        distance = far;
        const glm::dvec3 uvw = surface.uvw[a] + x * (surface.uvw[b] - surface.uvw[a]) +
                               y * (surface.uvw[c] - surface.uvw[a]);
        nearest = {ray.origin + far * ray.direction, glm::clamp(uvw, 0.0, 1.0)};
    }
    return nearest;
}

gpu::Translucent veil_of(const VolumeSurface& surface, ui::Color color)
{
    gpu::Translucent veil;
    veil.colors = {ui::linear_light(color)};
    veil.points.assign(surface.points.begin(), surface.points.end());
    veil.triangles = surface.triangles;
    return veil;
}

} // namespace trivar
