// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trivar {

// ImageTags are the names and words in a picture's file besides its pixels.
using ImageTags = std::vector<std::pair<std::string, std::string>>;

} // namespace trivar
