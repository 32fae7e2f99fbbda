// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Objects on the clipboard: the line of a scene file that adds copies of them, so that they can be
// pasted in another window, and read in any text editor. A copy of a placed object takes its stroke
// and how it lies with it, not what it lies on: see the command.
std::string clipboard_text(const Session& session, const std::vector<Id>& ids);

// Adds what such a text holds as one step, selects it and says so; copies that would stand in what
// they are copies of stand beside it. Other lines of a scene file are run, a step each. Any other
// text changes nothing, and a notice says why.
void paste_text(Session& session, std::string_view text);

// "Snake", or "3 objects".
std::string said_of(const Document& document, const std::vector<Id>& ids);

inline constexpr const char* of_clipboard = "clipboard"; // the topic of what is said about it

} // namespace trivar
