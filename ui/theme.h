// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/palette.h"

struct ImFont;

namespace trivar::ui {

// Metrics are sizes in pixels of the framebuffer: already multiplied by the scale and rounded.
struct Metrics {
    float unit; // 4 px at scale 1; every distance is a multiple of it
    float row, row_gap, group, top_bar, options_bar, status_bar, tool_strip, tool_button;
    float label, outliner, icon_button, padding;
    float rounding, rounding_small, rounding_card, hairline;
};

// Fonts other than `display` and `mono` carry the icons too; their figures are tabular.
struct Fonts {
    ImFont *body, *strong, *small, *small_strong, *title, *display, *mono, *tool, *large_icon;
};

struct ThemeOptions {
    float scale = 1; // content scale of the monitor times the user's interface scale, 0.75..3
    Look look = {};
};

struct Theme {
    Palette color;
    Metrics size;
    Fonts font;
    float scale = 1;
    Look look;
    float line(float at_scale_1) const; // width of a line on the picture, pixels
    float px(float at_scale_1) const;   // scaled and rounded to whole pixels
};

// The monitor's scale times the person's, within the limits of the interface.
float combined_scale(double content, double interface);

// Sets style, colours and fonts of the current ImGui context; call again when the scale changes,
// then renew the font texture. Throws Rejected naming each font that is missing and its package.
Theme apply_theme(const ThemeOptions& options);

// Reads font files; the atlas of the current ImGui context is built anew.
Fonts load_fonts(float scale);

} // namespace trivar::ui
