// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

// These functions draw shapes and text on the current window's draw list, in pixels. Text starts on
// whole pixels.

namespace trivar::ui {

struct Rect {
    glm::vec2 lo{0}, hi{0};
    glm::vec2 size() const { return hi - lo; }
    float width() const { return hi.x - lo.x; }
    float height() const { return hi.y - lo.y; }
    glm::vec2 center() const { return (lo + hi) / 2.0f; }
    bool contains(glm::vec2 p) const
    {
        return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y;
    }
    Rect grown(float by) const { return {lo - by, hi + by}; }
};
constexpr Rect rect_at(glm::vec2 at, glm::vec2 size)
{
    return {at, at + size};
}

float text_width(const ImFont* font, std::string_view text);
// Text stands in the middle of the rectangle's height, at its left, right or centre.
enum class Align { left, center, right };
void paint_text(const ImFont* font, const Rect& in, Color color, std::string_view text,
                Align align = Align::left);
// The text, or its beginning with an ellipsis where it does not fit.
std::string elided(const ImFont* font, std::string text, float width);
// The text broken into lines at spaces; a word that is too long stands alone.
std::vector<std::string> wrapped(const ImFont* font, std::string_view text, float width);

void paint_box(const Rect& rect, Color color, float rounding = 0);
void paint_rim(const Rect& rect, Color color, float rounding, float thickness);
void paint_dot(glm::vec2 center, float radius, Color color, Color rim = 0, float rim_width = 0);
// A ball of glass, lit from above left: transparent in the middle, nearly opaque at its rim.
void paint_ball(glm::vec2 center, float radius, Color color, float rim_width);
// A diamond on a corner; `fill` or `rim` 0: without it.
void paint_diamond(glm::vec2 center, float radius, Color fill, Color rim, float rim_width);
void paint_line(glm::vec2 a, glm::vec2 b, Color color, float thickness);
void paint_path(const std::vector<glm::vec2>& points, Color color, float thickness,
                bool closed = false);
// A card: soft shadow, raised surface, rim. The shadow may fall outside the current window.
void paint_card(const Theme& theme, const Rect& rect);
// A shadow round a rectangle; `reach` is its width in pixels, `strength` how dark it is inside.
void paint_shadow(const Rect& rect, float rounding, float reach, float strength);

// A small label on the picture with an optional dot or icon before it; returns its rectangle.
struct Chip {
    std::string text;
    Color dot = 0;
    const char* icon = nullptr;
    Color icon_color = 0;
};
Rect paint_chip(const Theme& theme, glm::vec2 at, const Chip& chip);

// Keys and mouse buttons for the status line; return their width.
float keycap_width(const Theme& theme, std::string_view text);
float paint_keycap(const Theme& theme, glm::vec2 at, float height, std::string_view text);
enum class MouseGlyph { left, middle, right, wheel };
float paint_mouse(const Theme& theme, glm::vec2 at, float height, MouseGlyph glyph);

} // namespace trivar::ui
