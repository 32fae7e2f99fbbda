// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <string>
#include <vector>

namespace trivar {

// A model that comes with the program: what it is called, and its file in the folder of models.
struct OwnModel {
    const char *name, *file;
    bool laid = true; // on something, as a rule; else others are laid on it
};
const std::vector<OwnModel>& own_models();

inline constexpr const char* models_menu = "Models"; // a menu of the menu Add

// Their pictures lie in a folder of this name beside those of the samples.
inline constexpr const char* model_pictures = "models";

// One for each of them: adds it to the scene as an import does. Where there is something that it
// can be laid on, the next stroke lays it; Escape leaves it where it stands.
void add_model_actions(std::vector<Action>& actions);

} // namespace trivar
