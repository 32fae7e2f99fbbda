// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/help/hints.h"

#include <optional>
#include <string>

namespace trivar {

struct Editor;

std::optional<HintCard> hint_card(const Editor& editor);
void close_hint(Editor& editor, const std::string& name);
void follow_hints(Editor& editor); // every frame: closes those whose step was made
void show_hints_again(Editor& editor);

} // namespace trivar
