// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <string_view>

namespace trivar {

// Whether a line is empty, or is no step but a line that a scene says of itself.
bool is_no_step(std::string_view line);

// Runs a typed line; returns why it was refused, or an empty text.
std::string run_typed(Session& session, std::string_view line);

bool holds_lines(std::string_view text); // more than one that is not empty

// Runs one line after another, each as a step, until one is refused: one notice tells that, and
// what ran before stays. Headers and digests of a scene are skipped.
void run_lines(Session& session, std::string_view text);

} // namespace trivar
