// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"
#include "core/stages/evaluated.h"

namespace trivar::testing {

// Whether along every edge between two positions as many faces run one way as the other. Positions
// are one where they are equal, bit for bit; nothing else of the program is asked.
bool encloses(const Mesh& mesh);

// Says which part is open of an object whose shape is closed and whose steps keep it so; empty:
// none.
std::string open_part(const Object& object, const EvaluatedObject& shown);

} // namespace trivar::testing
