// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

namespace trivar {

// A point near the middle of a box from which positions in the box keep their detail in single
// precision: 0 where they do so from 0, which loses less than 1e-5 of the size of the box, and else
// in each axis a multiple of a power of two near that size, so that taking it from numbers of
// single precision is exact.
glm::dvec3 far_origin(const Box& box);

} // namespace trivar
