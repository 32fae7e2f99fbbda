// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <string>

namespace trivar {

struct Editor;

// Uses a picture for the selection: a layer of tiles gets a mask of its density, anything else is
// displaced by it.
void use_image(Editor& editor, const std::string& path);

// Asks for a picture: for a new mask of a layer, or in place of that of one of its masks.
void ask_mask_image(Editor& editor, int layer, int number = 0);

// Another picture for a sheet of heights.
void change_heights_image(Editor& editor, int id, const std::string& path);

void add_mask_actions(std::vector<Action>& actions);

} // namespace trivar
