// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/incising.h"
#include "editor/panels/inspector/value_rows.h"

namespace trivar {

// The points that a hand chose on the curves of an incision; -1: none.
struct ChosenCutPoints {
    int depth = -1, width = -1;
};

// The rows of one incision's numbers and profiles. `number`: the first is 1.
void draw_incision_rows(ValueRows& rows, NamedIncision& incision, int number,
                        ChosenCutPoints& chosen);

// The points with which a custom profile begins where the shape was another one.
std::vector<glm::dvec2> custom_points(const IncisionProfile& profile);

} // namespace trivar
