// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"

#include <string>
#include <vector>

namespace trivar::ui {

// A piece of a paragraph. A key is drawn as a cap, or as several where it names several: "Ctrl Z".
struct Run {
    enum class Kind { plain, strong, key, link } kind = Kind::plain;
    std::string text;
    std::string target = {}; // of a link
    bool operator==(const Run&) const = default;
};

struct RichStyle {
    const ImFont *font, *strong;
    Color ink, strong_ink;
    float line; // height, pixels
};

// A paragraph in a column, broken between words; its height.
float rich_height(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                  float width);
// Draws it, and returns its height and the target of the link that was clicked.
struct DrawnText {
    float height = 0;
    std::string clicked;
};
DrawnText draw_rich(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                    glm::vec2 at, float width);

} // namespace trivar::ui
