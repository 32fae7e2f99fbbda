// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/timeline/timeline.h"

#include <map>

namespace trivar {

// Where frames and values stand among the curves, in pixels.
struct CurveScale {
    FrameScale frames;
    float top = 0, bottom = 0; // of the greatest and the least value that is shown
    glm::dvec2 values{0, 1};   // those, the least first
    float y(double value) const;
    double value_at(float y) const;
    double share_at(float y) const; // of the height, from below
    glm::vec2 at(double frame, double value) const { return {frames.x(frame), y(value)}; }
};

// Curves that stand by the same values, or each by its own: what it reaches fills the height.
struct CurveScales {
    CurveScale all; // where they have their own, between shares of what they reach
    std::map<TrackName, glm::dvec2> own;
    CurveScale of(const TrackName& track) const;
};
bool units_differ(const std::vector<TrackName>& tracks);

// Between which values all that these curves reach lies, as they are shown; a little more where
// that is one value. The names of chosen keys instead of the tracks: what these reach.
glm::dvec2 values_of_curves(const Document& document, const std::vector<TrackName>& tracks);
glm::dvec2 values_of_keys(const Document& document, const ChosenKeys& keys,
                          const CurveScales& scales);

// What is shown when the wheel has turned so many notches over that value.
glm::dvec2 zoomed_values(glm::dvec2 shown, double value, double notches);

// The curve from key to key, and before and after them where the picture reaches further: places
// in pixels. `inside`: only from the first key to the last.
std::vector<glm::vec2> curve_path(const Track& track, const CurveScale& scale, double factor,
                                  bool inside);

// Round numbers between the values, so many pixels or more apart: the first one and the step.
struct ValueTicks {
    double first = 0, step = 1;
};
ValueTicks value_ticks(const CurveScale& scale, float least_px);

} // namespace trivar
