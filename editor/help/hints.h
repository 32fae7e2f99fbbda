// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A HintCard is a card at the foot of the picture that guides a person through the first stroke. It
// leaves when its step was done, or when it is closed; preferences remember that, so that none
// comes twice.
struct HintCard {
    std::string name; // in the preferences
    int number = 0;   // of the three; 0: the scene lacks what a stroke needs
    std::string title, body;
    std::string with_models = {}; // the body where there is room for pictures of what is offered
    std::vector<std::string> offers = {}; // actions that do it: models that come with the program,
                                          // by their pictures, then others
};
} // namespace trivar
