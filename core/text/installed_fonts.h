// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/font.h"

#include <string>
#include <vector>

namespace trivar {

struct InstalledFont {
    std::string family, style, path;
    int face = 0;      // see Font
    int plainness = 0; // how far its weight, slant and width are from the family's plain one
    std::string title() const { return style.empty() ? family : family + " " + style; }
};

// The TrueType and OpenType outline fonts of this computer, by title; tens of milliseconds.
std::vector<InstalledFont> installed_fonts();

// The one of that family, family and style, or full name, whatever case the letters have; of a
// family the plain style. Null: there is none.
const InstalledFont* named_font(const std::vector<InstalledFont>& fonts, const std::string& name);

// Whether a font is named by the path of its file.
bool is_font_path(const std::string& name);

struct FoundFont {
    Font font;
    std::vector<std::string> notices; // that another one stands in
};
// The font of that name, or of that file, face 0 of it. Where there is none DejaVu Sans stands in,
// else the first one installed; throws Rejected where there is none of these either.
FoundFont find_font(const std::string& name);

} // namespace trivar
