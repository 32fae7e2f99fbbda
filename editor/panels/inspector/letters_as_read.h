// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "ui/widgets.h"

#include <array>
#include <string_view>

namespace trivar {

// LetterFronts are the fronts of letters, in the text's X and Y: their triangles, and the edges
// round them.
struct LetterFronts {
    std::vector<std::array<glm::vec2, 3>> triangles;
    std::vector<std::array<glm::vec2, 2>> rim;
    glm::vec2 lo{0}, hi{0}; // of the box that they fill
};
LetterFronts letter_fronts(const Mesh& text);

// Whether a field shows the letters as they are read: it knows neither right-to-left nor all
// scripts.
bool field_shows(std::string_view utf8);

// Draws the letters as they stand in the scene under the field, of that size, where the field
// cannot show them.
void draw_letters_as_read(const ui::Theme& theme, const Mesh& text, double em);

} // namespace trivar
