// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/palette_entries.h"
#include "editor/words/ranked.h"
#include "ui/paint.h"
#include "ui/theme.h"

#include <optional>

namespace trivar {

// PaletteRows are the rows of the palette: the found entries, under a caption in capitals.
struct PaletteRows {
    std::vector<PaletteEntry> entries;
    std::vector<RankedName> found;
    const char* caption = "";
};
// Returns the index in `found` that was clicked. `chosen` follows the mouse; there may be none.
std::optional<std::size_t> draw_rows(const ui::Theme& theme, const ui::Rect& r,
                                     const PaletteRows& rows, std::optional<std::size_t>& chosen,
                                     bool chosen_by_key);

// Draws keys with what they do, in a line with a rule above it: the first and the last of them, and
// as many as fit.
struct PaletteHint {
    std::vector<std::string> caps;
    std::string verb;
};
void draw_palette_hints(const ui::Theme& theme, const ui::Rect& r, std::vector<PaletteHint> hints);

} // namespace trivar
