// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/font.h"

#include <string>
#include <vector>

namespace trivar {

struct InstalledFont {
    std::string family, style, path;
    int face = 0;      // see Font
    int plainness = 0; // distance of its weight, slant and width from the family's plain style
    std::string title() const { return style.empty() ? family : family + " " + style; }
};

// The TrueType and OpenType outline fonts of this computer, by title; takes tens of milliseconds.
std::vector<InstalledFont> installed_fonts();

// The font with that family, family and style, or full name, in any case of letters; for a family
// its plain style. Null: there is none.
const InstalledFont* named_font(const std::vector<InstalledFont>& fonts, const std::string& name);

// Whether a font is named by the path of its file.
bool is_font_path(const std::string& name);

struct FoundFont {
    Font font;
    std::vector<std::string> notices; // says that another font replaces it
};
// The font of that name, or face 0 of that file. Where there is none, DejaVu Sans replaces it, or
// else the first installed font; throws Rejected where there is no font at all.
FoundFont find_font(const std::string& name);

} // namespace trivar
