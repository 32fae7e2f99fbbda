// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/rich_text.h"

#include <vector>

namespace trivar {

struct Editor;

// The runs with @NAME, the name of an action, as the key it has at present, or where it has none as
// its place in the menus. What no action is called stays as it is.
std::vector<ui::Run> with_keys(const Editor& editor, const std::vector<ui::Run>& runs);

} // namespace trivar
