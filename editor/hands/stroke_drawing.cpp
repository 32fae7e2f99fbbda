// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/stroke_drawing.h"

#include "core/placement/redraw.h"
#include "editor/hands/tool.h"
#include "editor/hands/viewport_input.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double closing_px = 40;  // from the start, at scale 1
constexpr double longest_loop = 3; // a ring is at least so many times as long as that
constexpr double step_px = 4;      // of a straight piece

} // namespace

void StrokeDrawing::begin(const Camera& camera, double time_s)
{
    *this = {};
    sketch_.camera = camera;
    began_s_ = time_s;
}

void StrokeDrawing::add(StrokeSample sample)
{
    std::vector<StrokeSample>& samples = sketch_.samples;
    // A mouse that rests repeats itself.
    if (!samples.empty() && samples.back().p_px == sample.p_px) return;
    if (straight_ && !samples.empty()) {
        samples.resize(std::max<std::size_t>(1, std::min(corner_, samples.size())));
        const StrokeSample from = samples.back();
        const double length = glm::distance(from.p_px, sample.p_px);
        const int steps = std::max(1, static_cast<int>(length / step_px));
        for (int i = 1; i < steps; ++i) {
            const double f = static_cast<double>(i) / steps;
            samples.push_back({glm::mix(from.p_px, sample.p_px, f),
                               from.time_s * (1 - f) + sample.time_s * f,
                               from.pressure * (1 - f) + sample.pressure * f});
        }
    }
    samples.push_back(sample);
}

bool StrokeDrawing::take(const std::vector<StrokeSample>& moves, const StrokeKeys& keys)
{
    const std::vector<StrokeSample> before = sketch_.samples;
    if (keys.straight && !straight_) corner_ = sketch_.samples.size();
    straight_ = keys.straight;
    for (StrokeSample sample : moves) {
        // A hand that leaves the picture draws nothing there.
        if (glm::any(glm::lessThan(sample.p_px, glm::dvec2(0))) ||
            glm::any(glm::greaterThan(sample.p_px, sketch_.camera.size_px)))
            continue;
        sample.time_s -= began_s_;
        sample.pressure = keys.pressure;
        if (snapped_) { // what the snap added goes as soon as the hand goes on
            sketch_.samples.pop_back();
            snapped_ = false;
        }
        add(sample);
    }
    std::vector<StrokeSample>& samples = sketch_.samples;
    const double near = closing_px * keys.scale;
    if (keys.close && !snapped_ && samples.size() > 2 && length_px(samples) > longest_loop * near &&
        glm::distance(samples.back().p_px, samples.front().p_px) < near) {
        StrokeSample end = samples.back();
        end.p_px = samples.front().p_px;
        samples.push_back(end);
        snapped_ = true;
    } else if (!keys.close && snapped_) {
        samples.pop_back();
        snapped_ = false;
    }
    return samples != before;
}

bool StrokeDrawing::is_click() const
{
    const std::vector<StrokeSample>& samples = sketch_.samples;
    return std::all_of(samples.begin(), samples.end(), [&](const StrokeSample& s) {
        return glm::distance(s.p_px, samples.front().p_px) <= click_slip_px;
    });
}

} // namespace trivar
