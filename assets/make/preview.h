// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

// Four shaded views (three quarters, side, top, front) as a PPM picture: the mirror while shaping.
void write_preview(const Model& model, const std::string& path, int clip = -1, int key = 0);

} // namespace make
