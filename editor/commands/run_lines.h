// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <string_view>

namespace trivar {

// A line that is empty, or what a scene says of itself.
bool is_no_step(std::string_view line);

// Runs what a person typed; why it was refused, or nothing.
std::string run_typed(Session& session, std::string_view line);

bool holds_lines(std::string_view text); // more than one that is not empty

// Runs one line after another, each a step, till one is refused: that is told in one notice, and
// what ran before stays. Headers and digests of a scene are passed over.
void run_lines(Session& session, std::string_view text);

} // namespace trivar
