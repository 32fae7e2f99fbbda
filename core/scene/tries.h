// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

namespace trivar {

// Whether two commands do the same to the same objects, with the same strokes, and differ at most
// in their numbers: then the second can stand in the place of the first. Kinds without such numbers
// never do.
bool differ_in_numbers_only(const Command& a, const Command& b);

// Whether the branch is one step that was made again with other numbers, in the steps there are or
// in a later branch. Of such tries the last one counts: the others stay in the log and can be
// brought back from there, but nobody looks for them among what else was done.
bool is_replaced_try(const History& history, std::size_t branch);

} // namespace trivar
