// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace trivar::ui {

using Color = std::uint32_t; // 0xAABBGGRR, sRGB, straight alpha: what the draw lists take

// A colour as the specification writes it: 0xRRGGBB and an alpha of 0..1.
constexpr Color rgb(unsigned hex, float alpha = 1)
{
    return ((hex >> 16) & 255u) | (hex & 0xFF00u) | ((hex & 255u) << 16) |
           (static_cast<unsigned>(alpha * 255.0f + 0.5f) << 24);
}

// The same colour, more transparent.
constexpr Color faded(Color color, float share)
{
    return (color & 0x00FFFFFFu) |
           (static_cast<unsigned>(static_cast<float>(color >> 24) * share) << 24);
}

// Every colour that the interface and its viewport overlays use, by meaning. Nothing else draws.
struct Palette {
    // Surfaces, from the back to the front.
    Color gap, base, panel, header, raised, raised_rim, field, field_hover, field_active,
        field_fill, segment;
    Color line, line_soft, scrim, row_hover, row_selected, row_selected_idle;
    // Text: each has a contrast of at least 4.5 to 1 wherever the specification allows it.
    Color text, text_2, text_3, text_off, on_accent;
    // Meaning.
    Color accent, accent_text, accent_hover, accent_active, focus;
    Color good, warn, bad, bad_fill, bad_fill_hover, key, changed;
    // The viewport. Hues are spaced for deuteranopia and protanopia; shape always says it too.
    Color sky_top, sky_bottom, grid, grid_major, axis_x, axis_y, axis_z;
    Color letter_x, letter_y, letter_z; // of the axes, on panels
    Color selected, hovered, lattice, lattice_fill, stroke, stroke_fill, contact, free_node, halo;
    Color sphere, incision, fold, path;
    Color chip, chip_text; // small labels that lie on the picture
    Color cpu, gpu;
};

Palette dark_palette();
Palette light_palette();

// A Look holds a person's choices. High contrast: no text is quieter than another, and overlays are
// wider. Other hues: overlays that differ from each other for eyes of every kind. Lines on the
// picture are `lines` times wider; the tooltip comes after the mouse has rested for that many
// seconds, and two clicks within that many seconds are a double click.
struct Look {
    bool light = false, high_contrast = false, other_hues = false;
    double lines = 1, tooltip_s = 0.5, double_click_s = 0.3;
    bool click_holds = false; // a click begins a drag, a second one ends it
    bool operator==(const Look&) const = default;
};
Palette palette_of(const Look& look);

// The same palette with the backdrop and the overlays of a light or a dark picture.
Palette with_overlays(Palette palette, const Look& look);

// Returns linear light with straight alpha, for the renderer.
glm::vec4 linear_light(Color color);

// The visible difference of two opaque colours (CIE 1976, distance in L*a*b*), for usual eyes or
// without one kind of cones (Machado, Oliveira, Fernandes 2009, severity 1).
enum class Eyes { usual, protanopia, deuteranopia, tritanopia };
double difference(Color a, Color b, Eyes eyes);

} // namespace trivar::ui
