// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/dice.h"
#include "tests/fuzz/hands/gesture.h"
#include "tests/fuzz/hands/start_scenes.h"

#include <string>
#include <vector>

namespace trivar::testing {

// GestureWords are the sets from which gestures are drawn.
struct GestureWords {
    std::vector<std::string> tools;    // their keys
    std::vector<std::string> chords;   // keys of all actions
    std::vector<std::string> entries;  // names in the palette
    std::vector<std::string> commands; // lines of JSON, one of each kind
};
GestureWords all_words();

// The gestures of one case in the scene. Most cases keep to one tool that has something to do
// there, as a hand does that works at something.
std::vector<Gesture> drawn_gestures(const GestureWords& words, const StartScene& scene, Dice& dice,
                                    int count);

} // namespace trivar::testing
