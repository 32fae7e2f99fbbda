// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trivar {

// ImageTags are what a picture's file says besides its pixels: names and words.
using ImageTags = std::vector<std::pair<std::string, std::string>>;

} // namespace trivar
