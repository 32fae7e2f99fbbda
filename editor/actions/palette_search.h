// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/palette_entries.h"
#include "editor/words/ranked.h"

namespace trivar {

// Searches the entries, the best first: names that hold the typed text as it stands, then entries
// that other programs call by that word (editor/words/synonyms.h), then names that hold its letters
// in order, if they are few or nothing was found before, then entries whose description has a word
// that begins with it. Without letters: the recent ones, then all others.
std::vector<RankedName> found_entries(std::string_view typed,
                                      const std::vector<PaletteEntry>& entries,
                                      const std::vector<std::string>& recent);

} // namespace trivar
