// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/step_title.h"

#include <vector>

// What differs between two values of a command, for the titles of steps.

namespace trivar {

struct Change {
    std::string name, value; // as a panel calls it; what it is now, with its unit
};
using Changes = std::vector<Change>;

Changes changes(const PlacementParameters& before, const PlacementParameters& after);
Changes changes(const Surfacing& before, const Surfacing& after);
Changes changes(const RenderSettings& before, const RenderSettings& after);
Changes changes(const Travel& before, const Travel& after);
Changes changes(const Playing& before, const Playing& after);
Changes changes(const Time& before, const Time& after);

// Three significant digits, no trailing zeros: "0.24", "12.3", "4".
std::string brief_number(double value);
std::string in_metres(double value);
std::string in_degrees(double value);
std::string in_seconds(double value);

// "Width of Snake" "0.24 m"; "Width and height of Snake"; `whole` "of Snake" for more of them.
StepTitle title_of_changes(const Changes& changes, const std::string& whole,
                           const std::string& object);

} // namespace trivar
