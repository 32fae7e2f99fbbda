// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar {

// A material that shows UVs: squares, a sixteenth of the texture wide, light and dark in turn and
// of another colour in each row and column, with an arrow along v in each, so that a mirrored or
// turned texture is seen.
Material checker_material();

} // namespace trivar
