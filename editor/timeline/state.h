// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "editor/timeline/keys_view.h"

#include <optional>

namespace trivar {

// TimelineState is the state of the timeline, and of a drag of the bar of a travelling object.
struct TimelineState {
    enum class Hand { none, shift, begin, end }; // what of a bar is dragged
    Hand hand = Hand::none;
    Id id = 0;
    Travel travel;                        // before it was
    double grabbed = 0, from = 0, to = 0; // frames: under the mouse, and the bar's ends then
    bool hovered = false;
    std::optional<glm::dvec2> shown; // the frames between which it is open; none: all
    KeysView keys;
};

} // namespace trivar
