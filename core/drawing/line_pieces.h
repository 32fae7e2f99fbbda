// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/ink.h"

#include <span>

namespace trivar {

// A LinePiece is a part of a line that is of one colour, as far as a screen shows it. Each begins
// with the last point of the one before.
struct LinePiece {
    std::span<const InkedLine::Point> points; // at least 2
    glm::vec3 color{0};                       // sRGB
    double along = 0;                         // pixels from the beginning of the line
};

std::vector<LinePiece> pieces_of(const InkedLine& line);

// Whether a line is drawn as a stroke of one width; others are filled outlines.
bool is_one_stroke(const InkedLine& line);

// The width that a line of one width has in a file; of others, that of their middle.
float width_of(const InkedLine& line);

// The length in pixels of each dash of a line, and of each gap after one; 0: it has none. Dashes
// have flat ends, and go on from piece to piece.
double dash_of(const InkedLine& line);

// The outline of a line of changing width: both of its sides, there and back. Pixels.
std::vector<glm::dvec2> outline_of(std::span<const InkedLine::Point> points);

} // namespace trivar
