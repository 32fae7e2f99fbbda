// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/carried_samples.h"

#include "core/base/number_text.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Enlarges the picture on all sides, so that it holds all samples.
void widen(Sketch& sketch)
{
    glm::dvec2 lo(0), hi = sketch.camera.size_px;
    for (const StrokeSample& sample : sketch.samples) {
        lo = glm::min(lo, sample.p_px);
        hi = glm::max(hi, sample.p_px);
    }
    const glm::dvec2 more = glm::max(-lo, hi - sketch.camera.size_px);
    if (more == glm::dvec2(0)) return;
    Camera& camera = sketch.camera;
    const double higher = (camera.size_px.y + 2 * more.y) / camera.size_px.y;
    camera.fov_y = 2 * std::atan(std::tan(camera.fov_y / 2) * higher);
    camera.height_world *= higher;
    camera.size_px += 2.0 * more;
    for (StrokeSample& sample : sketch.samples) sample.p_px += more;
}

// Interpolates the displacements of samples between known ones evenly; samples before the first and
// after the last known one get its displacement.
void fill_between(std::vector<glm::dvec2>& by, const std::vector<char>& known)
{
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < by.size(); ++i)
        if (known[i]) at.push_back(i);
    if (at.empty()) return;
    for (std::size_t i = 0; i < by.size(); ++i) {
        if (known[i]) continue;
        const auto next = std::ranges::upper_bound(at, i);
        if (next == at.begin())
            by[i] = by[at.front()];
        else if (next == at.end())
            by[i] = by[at.back()];
        else {
            const std::size_t a = *(next - 1), b = *next;
            const double share = static_cast<double>(i - a) / static_cast<double>(b - a);
            by[i] = glm::mix(by[a], by[b], share);
        }
    }
}

// Adds a notice if hosts have moved apart where the stroke passes from one to the other.
void tell_gaps(StrokeMotion& stroke_motion, const StrokeHosts& stroke,
               const std::vector<glm::dvec3>& places)
{
    const std::vector<SampleFoot>& feet = stroke.feet;
    double length = 0, widest = 0;
    std::size_t before = feet.size();
    for (std::size_t i = 0; i < feet.size(); ++i) {
        if (!feet[i].now) continue;
        if (before < feet.size()) {
            const double then = glm::distance(feet[before].drawn, feet[i].drawn),
                         now = glm::distance(places[before], places[i]);
            length += then;
            if (stroke.attachment.samples[before].host != stroke.attachment.samples[i].host)
                widest = std::max(widest, now - then);
        }
        before = i;
    }
    constexpr double much = 0.1; // of the stroke
    if (widest > much * length)
        stroke_motion.notices.push_back(
            fmt::format("its hosts have moved {} m apart; it spans the gap", number_text(widest)));
}

// Adds a notice if a host, or a part of one, is missing: what lay on it moves with the rest.
void tell_missing(StrokeMotion& stroke_motion, const StrokeHosts& stroke)
{
    for (std::size_t i = 0; i < stroke.feet.size(); ++i)
        if (stroke.attachment.samples[i].host >= 0 && !stroke.feet[i].now) {
            stroke_motion.notices.emplace_back("a part of its hosts is not visible in this frame; "
                                               "what lay on that goes with the rest");
            return;
        }
}

} // namespace

void carry_samples(StrokeMotion& stroke_motion, const StrokeHosts& stroke)
{
    Sketch& sketch = stroke_motion.sketch;
    const std::vector<SampleFoot>& feet = stroke.feet;
    tell_missing(stroke_motion, stroke);
    if (feet.size() != sketch.samples.size()) return;
    const View view(sketch.camera);
    std::vector<glm::dvec2> by(feet.size(), glm::dvec2(0));
    std::vector<char> known(feet.size(), 0);
    std::vector<glm::dvec3> places(feet.size());
    bool any = false;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        if (!feet[i].now) continue;
        const HostNow& now = stroke.host_of(i);
        places[i] = now.unmoved ? feet[i].drawn : taken_by(now.own_to_drawn, feet[i].now->p);
        known[i] = 1;
        if (now.unmoved) continue;
        const PicturePoint then = view.project(feet[i].drawn), here = view.project(places[i]);
        known[i] = then.depth_world > 0 && here.depth_world > 0;
        by[i] = known[i] ? here.p_px - then.p_px : glm::dvec2(0);
        any = any || by[i] != glm::dvec2(0);
    }
    tell_gaps(stroke_motion, stroke, places);
    if (!any) return;
    fill_between(by, known);
    for (std::size_t i = 0; i < by.size(); ++i) sketch.samples[i].p_px += by[i];
    widen(sketch);
}

} // namespace trivar
