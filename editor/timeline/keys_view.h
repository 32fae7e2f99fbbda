// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/timeline/key_edits.h"

#include <optional>

namespace trivar {

// A KeyGesture is a drag of keys in the open timeline: a button is held, or, begun by a key, a
// click will end it. Each gesture is one proposal, always from the state before it, and one step in
// the end.
struct KeyGesture {
    enum class Hand { none, move, copy, scale, box, handle };
    Hand hand = Hand::none;
    bool by_key = false, strayed = false; // the hand went further than a click does
    ChosenKeys before;                    // that were chosen
    glm::dvec2 grabbed{0};                // frame, and share of the height, under the mouse
    glm::vec2 grabbed_px{0};
    double about = 0; // frame: of scaling
    KeyName key;      // the one under the mouse, or that whose handle it is
    KeyHandle which = KeyHandle::after;
    glm::dvec2 values{0}; // that were shown, so that nothing moves under the hand
};

// A KeysView says how the open timeline shows keys, and which of them are chosen.
struct KeysView {
    bool curves = false;
    std::set<Id> unfolded;      // objects, 0: the scene, whose tracks have rows
    std::set<TrackName> tracks; // whose rows are chosen
    ChosenKeys chosen;
    // The values between which curves are shown; where each curve fills the height by itself,
    // shares of its own range; empty: all values.
    std::optional<glm::dvec2> values;
    std::optional<bool> alone; // each fills the height by itself; none: where their units differ
    bool was_alone = false;    // when they were drawn last
    bool fit_chosen = false;   // asked for
    std::optional<KeyGesture::Hand> asked; // a gesture that begins where the mouse is
    KeyGesture gesture;
    ChosenKeys typed; // that were chosen when a hand began on one of their numbers
};

} // namespace trivar
