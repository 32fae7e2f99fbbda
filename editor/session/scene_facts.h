// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// Whether it is that object or in that group, however deep; everything is in 0.
bool belongs_to(const Document& document, Id id, Id group);
// Whether the scene looks different from frame to frame.
bool moves_in_time(const Document& document);

// What travels, in the order of the outliner's rows.
std::vector<Id> travelling(const Document& document);
// The name in the outliner, or nothing for an id that is gone.
std::string name_of(const Document& document, Id id);

} // namespace trivar
