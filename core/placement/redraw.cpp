// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/redraw.h"

#include "core/base/share_along.h"
#include "core/placement/sketch.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

using Samples = std::vector<StrokeSample>;

// Returns the shares of the length up to each sample; even ones if the length is 0.
std::vector<double> shares(const Samples& samples)
{
    std::vector<double> out(samples.size(), 0);
    for (std::size_t i = 1; i < samples.size(); ++i)
        out[i] = out[i - 1] + glm::distance(samples[i].p_px, samples[i - 1].p_px);
    const double length = out.empty() ? 0 : out.back();
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = length > 0 ? out[i] / length
                            : static_cast<double>(i) /
                                  std::max<double>(1, static_cast<double>(out.size() - 1));
    return out;
}

std::size_t nearest_sample(const Samples& samples, glm::dvec2 p)
{
    const auto nearest = std::min_element(
        samples.begin(), samples.end(), [&](const StrokeSample& a, const StrokeSample& b) {
            return glm::distance(a.p_px, p) < glm::distance(b.p_px, p);
        });
    return static_cast<std::size_t>(nearest - samples.begin());
}

Samples reversed(const Samples& samples)
{
    Samples out(samples.rbegin(), samples.rend());
    for (StrokeSample& s : out) s.time_s = samples.back().time_s - s.time_s;
    return out;
}

// Appends samples, with their times shifted to the end.
void append(Samples& to, const Samples& more, std::size_t from, std::size_t end)
{
    if (from >= end) return;
    const double shift = to.empty() ? 0 : to.back().time_s - more[from].time_s;
    for (std::size_t i = from; i < end; ++i) {
        to.push_back(more[i]);
        to.back().time_s += shift;
    }
}

glm::dvec2 direction(const Samples& samples, std::size_t from, int step)
{
    // The direction is taken over some pixels, because the first ones of a hand tremble.
    constexpr double far_px = 12;
    const auto end = static_cast<std::ptrdiff_t>(samples.size());
    glm::dvec2 d(0);
    for (std::ptrdiff_t i = static_cast<std::ptrdiff_t>(from); i >= 0 && i < end; i += step) {
        d = samples[static_cast<std::size_t>(i)].p_px - samples[from].p_px;
        if (glm::length(d) >= far_px) break;
    }
    return d;
}

} // namespace

Samples seen_from(const Camera& sketch, const Camera& drawn_in, const Samples& samples,
                  const RayScene& scene)
{
    if (sketch == drawn_in) return samples;
    const View from(drawn_in), to(sketch);
    std::vector<Ray> rays;
    for (const StrokeSample& s : samples) rays.push_back(from.ray(s.p_px));
    const auto hits = scene.hits(rays);
    const auto first =
        std::find_if(hits.begin(), hits.end(), [](const auto& h) { return h.has_value(); });
    if (first == hits.end()) return {};
    double distance = (*first)->distance;
    Samples out;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (hits[i]) distance = hits[i]->distance;
        const PicturePoint p = to.project(rays[i].origin + distance * rays[i].direction);
        if (!(p.depth_world > 0)) continue;
        out.push_back(samples[i]);
        out.back().p_px = p.p_px;
    }
    return out;
}

NearestShare nearest_share(const Sketch& sketch, glm::dvec2 p)
{
    const Samples& samples = sketch.samples;
    const std::vector<double> share = shares(samples);
    NearestShare nearest{0, glm::distance(samples.front().p_px, p)};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const glm::dvec2 a = samples[i - 1].p_px, ab = samples[i].p_px - a;
        const double f = share_along(p, a, ab);
        const double distance = glm::distance(a + f * ab, p);
        if (distance < nearest.distance_px)
            nearest = {share[i - 1] + f * (share[i] - share[i - 1]), distance};
    }
    return nearest;
}

double length_px(const Samples& samples)
{
    double sum = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        sum += glm::distance(samples[i].p_px, samples[i - 1].p_px);
    return sum;
}

Sketch redrawn(const Sketch& sketch, const Samples& piece, double near_px)
{
    const Samples& old = sketch.samples;
    if (piece.size() < 2) return sketch;
    const std::size_t leaves = nearest_sample(old, piece.front().p_px);
    const std::size_t meets = nearest_sample(old, piece.back().p_px);
    Sketch out{sketch.camera, {}};
    if (leaves != meets && glm::distance(old[meets].p_px, piece.back().p_px) <= near_px) {
        append(out.samples, old, 0, std::min(leaves, meets));
        append(out.samples, leaves < meets ? piece : reversed(piece), 0, piece.size());
        append(out.samples, old, std::max(leaves, meets) + 1, old.size());
        return out;
    }
    const glm::dvec2 sets_out = direction(piece, 0, 1);
    // At an end only one side can be compared.
    const glm::dvec2 onward =
        leaves + 1 < old.size() ? direction(old, leaves, 1) : -direction(old, leaves, -1);
    if (glm::dot(sets_out, onward) >= 0) {
        append(out.samples, old, 0, leaves);
        append(out.samples, piece, 0, piece.size());
    } else {
        append(out.samples, reversed(piece), 0, piece.size());
        append(out.samples, old, leaves + 1, old.size());
    }
    return out;
}

Sketch bent(const Sketch& sketch, double share, glm::dvec2 by_px, double reach)
{
    Sketch out = sketch;
    const std::vector<double> at = shares(sketch.samples);
    const bool ring =
        glm::distance(sketch.samples.front().p_px, sketch.samples.back().p_px) <= ring_closing_px;
    for (std::size_t i = 0; i < at.size(); ++i) {
        double away = std::abs(at[i] - share);
        if (ring) away = std::min(away, 1 - away);
        if (away >= reach) continue;
        const double c = std::cos(away / reach * glm::half_pi<double>());
        out.samples[i].p_px += c * c * by_px;
    }
    return out;
}

} // namespace trivar
