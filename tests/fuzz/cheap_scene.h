// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace trivar::testing {

// Whether a scene can be worked out within some hundredths of a second: few vertices and control
// points, no letters, nothing refined or subdivided. Damaged numbers ask for as much as they may.
bool is_cheap(const Document& document);

} // namespace trivar::testing
