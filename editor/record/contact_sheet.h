// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string_view>
#include <vector>

namespace trivar {

// COLUMNSxROWS, such as 3x2. Throws Rejected.
glm::ivec2 sheet_grid(std::string_view text);

// `count` of these frames, evenly chosen, with the first and the last; all of them where there are
// no more.
std::vector<int> evenly_chosen(const std::vector<int>& frames, int count);

// Pictures of one size side by side, row by row from the top left, with narrow gaps between.
Image contact_sheet(const std::vector<Image>& pictures, int columns);

} // namespace trivar
