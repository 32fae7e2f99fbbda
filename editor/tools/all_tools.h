// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/tool.h"

#include <memory>
#include <vector>

namespace trivar {

std::vector<std::unique_ptr<Tool>> all_tools();

} // namespace trivar
