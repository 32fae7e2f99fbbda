// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/incising.h"
#include "editor/tools/incise/seen_incision.h"
#include "ui/widgets.h"

namespace trivar {

// A WoundSection is an incision unrolled along its length: how thick the body is below it, and what
// its walls show. Lengths in metres on the model.
struct WoundSection {
    double length = 0;
    std::vector<double> thickness;                    // at equal steps of its length; 0: not known
    std::vector<std::pair<double, glm::vec4>> layers; // down to which depth, linear colour
};

// The section of an incision that is seen; it has no length where it is not.
WoundSection section_of(const IncisedSkin& skin, const NamedIncision& incision,
                        const std::vector<IncisionLayer>& layers);

// Draws the section: above the skin how wide it gapes, below how deep it goes. A hand that draws
// above the skin gives the incision another opening profile, and below it another depth profile.
ui::Edit draw_wound_section(const ui::Theme& theme, const WoundSection& section, Incision& cut,
                            float width);

// The profile with a line drawn over it from one place to another, (share of the length, share of
// the greatest value): it becomes a custom one.
IncisionProfile drawn_over(const IncisionProfile& profile, glm::dvec2 from, glm::dvec2 to);

} // namespace trivar
