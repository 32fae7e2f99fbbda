// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace trivar {

struct Editor;

// The cards at the foot of the picture that lead a hand through its first stroke. Each goes when
// what it says was done, or when it is closed; preferences keep that, so that none comes twice.
struct HintCard {
    std::string name; // in the preferences
    int number = 0;   // of the three; 0: the scene lacks what a stroke needs
    std::string title, body;
};
std::optional<HintCard> hint_card(const Editor& editor);
// The steps that are known: of which scene, and how many.
struct FollowedSteps {
    long scene = -1;
    std::size_t count = 0;
};

void close_hint(Editor& editor, const std::string& name);
void follow_hints(Editor& editor); // every frame: closes those whose step was made
void show_hints_again(Editor& editor);

} // namespace trivar
