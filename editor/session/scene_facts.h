// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// Whether an object is the group itself or in it, at any depth; everything is in group 0.
bool belongs_to(const Document& document, Id id, Id group);
// Whether the scene looks different from frame to frame.
bool moves_in_time(const Document& document);
// Whether the object is a layer of tiles; not for an id that is gone.
bool is_tile_layer(const Document& document, Id id);
// Whether the brush makes tiles where there are none.
bool lays_tiles(TileBrush brush);
// Whether a layer of tiles is in it.
bool has_tiles(const Document& document);

// The travelling objects, in the order of the outliner's rows.
std::vector<Id> travelling(const Document& document);
// The name in the outliner; empty for an id that is gone.
std::string name_of(const Document& document, Id id);

} // namespace trivar
