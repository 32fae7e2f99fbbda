// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <vector>

namespace trivar::testing {

// Small bodies that have, all together, whatever a format can hold: polygons, groups, materials
// with every texture, colours, nodes below nodes, a skin, a morph target and clips.
std::vector<Model> sound_models();

} // namespace trivar::testing
