// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string>

namespace trivar {

// Throws Rejected, with the path in the sentence, where the file would be refused when it is read
// again, for no face of it would have three different corners. Looks at faces till one has.
void check_writable(const Model& model, const std::string& path);

} // namespace trivar
