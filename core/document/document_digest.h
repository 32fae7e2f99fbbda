// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>

namespace trivar {

// The digest of the causes, 32 hexadecimal digits.
std::string digest(const Document& document);

} // namespace trivar
