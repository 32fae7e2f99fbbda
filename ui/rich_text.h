// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"

#include <string>
#include <vector>

namespace trivar::ui {

// A Run is a piece of a paragraph. A key is drawn as a cap, or as several caps where it names
// several keys: "Ctrl Z".
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

// The height of a paragraph in a column, broken between words.
float rich_height(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                  float width);
// A DrawnText is the height of a drawn paragraph and the target of the link that was clicked.
struct DrawnText {
    float height = 0;
    std::string clicked;
};
DrawnText draw_rich(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                    glm::vec2 at, float width);

} // namespace trivar::ui
