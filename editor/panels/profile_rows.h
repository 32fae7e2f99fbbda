// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <vector>

namespace trivar {

// How a size of a placement changes along its stroke: a list of shapes to begin with and, where it
// changes, the curve and the numbers of the chosen point.
struct ProfileRows {
    std::string label, help;
    double size_world = 0; // that the factors multiply; 0: not known yet
    ui::Color color = 0;
};
ui::Edit draw_profile(const ui::Theme& theme, const ProfileRows& rows,
                      std::vector<glm::dvec2>& points, int& chosen);

} // namespace trivar
