// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace trivar {

// The tracks of an object from whose list, "tiles.masks.", some entries are gone: those of the
// other entries keep theirs, which has another number now.
std::vector<Track> without_entries(const Tracks& tracks, std::string_view list,
                                   const std::vector<char>& gone);
// The tracks of an object two entries of whose list have changed places.
std::vector<Track> with_swapped_entries(const Tracks& tracks, std::string_view list, std::size_t a,
                                        std::size_t b);

} // namespace trivar
