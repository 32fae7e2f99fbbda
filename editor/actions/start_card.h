// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

struct Editor;

// Whether the start card is shown: where it was asked for, and over a new scene that is empty.
bool shows_welcome(const Editor& editor);

} // namespace trivar
