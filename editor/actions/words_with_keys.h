// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/rich_text.h"

#include <vector>

namespace trivar {

struct Editor;

// The runs with @NAME, the name of an action, replaced by the action's present key, or by its place
// in the menus where it has no key. Names of no action stay.
std::vector<ui::Run> with_keys(const Editor& editor, const std::vector<ui::Run>& runs);

} // namespace trivar
