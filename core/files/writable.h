// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string>

namespace trivar {

// Whether files that are named so have curves.
bool holds_curves(const std::string& path);

// Throws Rejected, with the path in the sentence, where the file would be refused when it is read
// again, for no face of it would have three different corners, and there are no curves. Looks at
// faces till one has.
void check_writable(const Model& model, const std::string& path);

} // namespace trivar
