// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"

#include <cstddef>

namespace trivar {

struct Editor;

// A tool is lent where another one comes back by itself: while its key is held, once something was
// done with it; or for one model, until that lies on a stroke or is gone.
void lend_tool_while_held(Editor& editor, int key, std::size_t before);
// Place, for a model that was just added. Nothing is lent while a gesture runs.
void lend_place(Editor& editor, Id model);
void return_lent_tool(Editor& editor); // every frame, before the keys

} // namespace trivar
