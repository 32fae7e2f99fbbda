// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/field.h"

namespace make {

// A human face looking along +x; whole: with hair and open eyes, else a mask with closed ones.
Sample face(vec3 p, bool whole);

} // namespace make
