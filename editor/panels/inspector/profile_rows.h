// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/inspector/key_gutter.h"
#include "ui/widgets.h"

#include <vector>

namespace trivar {

// ChosenPoints are the points that a hand chose on the curves of a placement and on its height map;
// -1: none.
struct ChosenPoints {
    int width = -1, height = -1, across = -1, rise = -1, map = -1;
};

// A ProfileKind says what a curve of a placement controls: how a size changes along the stroke or
// across it, or how the height is distributed between floor and roof.
enum class ProfileKind { along, across, rise };
struct ProfileRows {
    std::string label;
    RowWords words;
    double size_world = 0; // the size that the factors multiply; 0: not known yet
    ui::Color color = 0;
    ProfileKind kind = ProfileKind::along;
    const KeyGutter* keys = nullptr;
};
// Draws a list of shapes to begin with and, where it is unfolded, the curve and the numbers of the
// chosen point.
ui::Edit draw_profile(const ui::Theme& theme, const ProfileRows& rows,
                      std::vector<glm::dvec2>& points, int& chosen);

} // namespace trivar
