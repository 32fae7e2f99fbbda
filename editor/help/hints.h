// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar {

// The cards at the foot of the picture that lead a hand through its first stroke. Each goes when
// what it says was done, or when it is closed; preferences keep that, so that none comes twice.
struct HintCard {
    std::string name; // in the preferences
    int number = 0;   // of the three; 0: the scene lacks what a stroke needs
    std::string title, body;
};
} // namespace trivar
