// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"

#include <span>

namespace trivar {

// The quantity that the width of a line follows: nothing, how steep the field is there (steep:
// fine), how far away it is (far: fine), or how sharply the surface turns away from sight (sharp:
// fine).
enum class LineWidth : std::uint8_t { even, by_slope, by_depth, by_bend };

// The quantity that the colour of a line follows: nothing, the slope as a hue (red low, blue high),
// the depth as a hue (red near, blue far: as ChromaDepth glasses want it), or the slope as a grey
// (steep: dark).
enum class LineColor : std::uint8_t { plain, hue_by_slope, hue_by_depth, grey_by_slope };

// The style of hidden lines.
enum class HiddenLines : std::uint8_t { none, faint, dashed, as_seen };

// A LineStyle says how lines are inked. Lengths are in pixels.
struct LineStyle {
    float width = 1.8f;
    float finest = 0.35f; // share of the width to which it may go down
    LineWidth width_by = LineWidth::even;
    LineColor color_by = LineColor::plain;
    glm::vec3 color{0.05f, 0.05f, 0.07f}; // sRGB, 0 .. 1
    float taper = 12;                     // length over which a loose end becomes fine
    float wobble = 0;                     // greatest distance from the line, as of a hand
    float pencil = 0;                     // 0 .. 1: how far it is like a pencil's; 0: as of a pen
    int seed = 1;                         // of the wobble and the pencil
    HiddenLines hidden = HiddenLines::none;
    float fan_step = 0;    // between the fans on a line, see fans(); 0: none
    float fan_length = 16; // of the longest hairs of a fan
    bool operator==(const LineStyle&) const = default;
};

// An InkedLine is a stroke ready to be drawn.
struct InkedLine {
    struct Point {
        glm::vec2 at; // pixels; where a hand has it, which may be beside p
        float width;
        glm::vec3 color; // sRGB
        glm::vec3 p{0};  // voxels
    };
    std::vector<Point> points;
    float opacity = 1;
    bool dashed = false;
    bool hidden = false;
    bool strays = false;    // whether its points in pixels are beside those in space
    std::uint64_t id = 0;   // of the stroke
    std::size_t stroke = 0; // its number among those that were inked
    bool is_even() const;   // of one width
};

// Inks strokes, hidden ones first. Slopes, depths and bends are taken relative to the range of
// those that are seen, without the outermost twentieth on each side. A wobble is of the place in
// space, so that lines keep it while the view turns; a pencil goes over a line three times.
std::vector<InkedLine> inked(std::span<const Stroke> strokes, const LineStyle& style);

} // namespace trivar
