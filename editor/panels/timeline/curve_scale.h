// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/timeline/timeline.h"

#include <map>

namespace trivar {

// A CurveScale says where frames and values stand among the curves, in pixels.
struct CurveScale {
    FrameScale frames;
    float top = 0, bottom = 0; // places of the greatest and the least shown value
    glm::dvec2 values{0, 1};   // those values, the least first
    float y(double value) const;
    double value_at(float y) const;
    double share_at(float y) const; // of the height, from the lower end
    glm::vec2 at(double frame, double value) const { return {frames.x(frame), y(value)}; }
};

// CurveScales give curves one common scale, or each its own, in which it fills the height.
struct CurveScales {
    CurveScale all; // where curves have their own scales: in shares of their range
    std::map<TrackName, glm::dvec2> own;
    CurveScale of(const TrackName& track) const;
};
bool units_differ(const std::vector<TrackName>& tracks);

// The range of values of all these curves, in shown units; slightly larger where it would be a
// single value. With names of chosen keys in place of tracks: the range of these keys.
glm::dvec2 values_of_curves(const Document& document, const std::vector<TrackName>& tracks);
glm::dvec2 values_of_keys(const Document& document, const ChosenKeys& keys,
                          const CurveScales& scales);

// The shown range after the wheel has turned `notches` notches over that value.
glm::dvec2 zoomed_values(glm::dvec2 shown, double value, double notches);

// The curve from key to key, and before and after them where the picture reaches further, as places
// in pixels. `inside`: only from the first key to the last.
std::vector<glm::vec2> curve_path(const Track& track, const CurveScale& scale, double factor,
                                  bool inside);

// ValueTicks are round numbers in the range, at least `least_px` pixels apart: the first one and
// the step.
struct ValueTicks {
    double first = 0, step = 1;
};
ValueTicks value_ticks(const CurveScale& scale, float least_px);

} // namespace trivar
