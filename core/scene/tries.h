// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

namespace trivar {

// Whether two commands do the same to the same objects, with the same strokes, and differ only in
// numbers: then the second can replace the first. Commands without such numbers never do.
bool differ_in_numbers_only(const Command& a, const Command& b);

// Whether a branch is one step that was made again with other numbers, in the present steps or in a
// later branch. Only the last of such tries counts: the others stay in the log and can be brought
// back from there, but nobody looks for them in the history.
bool is_replaced_try(const History& history, std::size_t branch);

} // namespace trivar
