// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <string>

namespace trivar {

// What a step did, as a person would say it: "Width of Snake" and "0.24 m".
struct StepTitle {
    std::string words;
    std::string number; // the one that matters, with its unit; empty: none does
    std::string text() const { return number.empty() ? words : words + " " + number; }
    bool operator==(const StepTitle&) const = default;
};

// Pure: `before` is what the command was applied to, `after` what came of it. Names what changed,
// in the words of the panels, and not the whole value that the command holds.
StepTitle step_title(const Command& command, const Document& before, const Document& after);

} // namespace trivar
