// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/gap.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double edge_on = 0.01; // cosine between surface and ray below which steps are useless
// Steps in cells: a shorter one is not worth another iteration, a longer one is not reliable.
constexpr double short_step = 0.03, longest_step = 0.5;
constexpr double exact_step = 1e-6; // if the last step may cross a crease
constexpr int most_steps = 8, most_over_creases = 16;
constexpr double past_edge = 1e-6; // parameters outside by less are rounding

} // namespace

Gap gap_at(const SurfaceTable& s, const View& view, const SceneSample& sample, double more_cells)
{
    const glm::dvec3 toward = view.toward_eye(sample.p_world);
    const glm::dvec2 cell = 1.0 / s.cells();
    const glm::dvec2 lo = -more_cells * cell, hi = 1.0 - lo;
    glm::dvec2 uv = sample.uv;
    const double enough = s.creased() ? exact_step : short_step;
    for (int i = 0; i < (s.creased() ? most_over_creases : most_steps); ++i) {
        const SurfaceTable::Jet jet = s.jet(uv);
        const glm::dvec3 r = sample.p_world - jet.value;
        const glm::dvec3 n = glm::cross(jet.u, jet.v);
        const double det = glm::dot(n, toward);
        if (!(det * det > edge_on * edge_on * glm::dot(n, n))) {
            // Seen from the edge there is no step to take, but the ray that gave
            // the sample, or the steps before, may have gone through this very point.
            const double gap = -glm::dot(r, toward);
            return {uv, gap, glm::length(r + gap * toward) <= edge_on * std::abs(gap)};
        }
        const glm::dvec2 step(glm::dot(glm::cross(r, jet.v), toward) / det,
                              glm::dot(glm::cross(jet.u, r), toward) / det);
        const glm::dvec2 to =
            glm::clamp(uv + glm::clamp(step, -longest_step * cell, longest_step * cell), lo, hi);
        const bool stays = glm::all(glm::lessThan(glm::abs(to - uv), enough * cell));
        const glm::dvec2 beyond = glm::abs(uv + step - to);
        uv = to;
        if (stays) return {uv, -glm::dot(n, r) / det, std::max(beyond.x, beyond.y) <= past_edge};
    }
    return {uv, 0, false};
}

std::vector<Gap> gaps(const SurfaceTable& s, const View& view, std::vector<SceneSample>& samples)
{
    std::vector<Gap> out(samples.size());
    parallel_blocks(samples.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            out[i] = gap_at(s, view, samples[i]);
            samples[i].uv = out[i].uv;
        }
    });
    return out;
}

} // namespace trivar
