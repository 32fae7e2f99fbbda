// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/volumes/phantom.h"

// A left foot that stands on z = -8. Millimetres; x to the outer side, y to the heel, z up.
namespace make {

Tissue foot_bones(); // of the ankle too; parts are bones, with the spaces of joints between them
Tissue foot_skin();

} // namespace make
