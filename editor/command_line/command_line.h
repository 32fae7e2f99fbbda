// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"

#include <string>
#include <vector>

namespace trivar {

// The whole program but for its window: arguments without the program's name. Never throws.
Status run_program(const std::vector<std::string>& arguments, const Streams& streams);

} // namespace trivar
