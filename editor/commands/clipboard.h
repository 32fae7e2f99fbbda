// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The text of objects on the clipboard: the line of a scene file that adds copies of them, so that
// they can be pasted in another window, and read in any text editor. A copy of a placed object
// takes its stroke and its placement with it, not the objects on which it lies: see the command.
std::string clipboard_text(const Session& session, const std::vector<Id>& ids);

// Adds the objects of such a text as one step, selects them and says so; copies that would stand
// inside their originals are moved beside them. Other lines of a scene file are run, one step per
// line. Any other text changes nothing, and a notice says why.
void paste_text(Session& session, std::string_view text);

// "Snake", or "3 objects".
std::string said_of(const Document& document, const std::vector<Id>& ids);

inline constexpr const char* of_clipboard = "clipboard"; // the topic of what is said about it

} // namespace trivar
