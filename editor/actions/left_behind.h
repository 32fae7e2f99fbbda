// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// What becomes of attached objects because a step deleted what carried them: sentences for the
// user, at most one per outcome. None: nothing that is left was carried by what went.
std::vector<std::string> left_behind(const Document& before, const Document& after);

} // namespace trivar
