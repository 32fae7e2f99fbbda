// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"

namespace trivar {

// About how far a part is from going evenly from one moment to the next, in metres: from every
// second moment, which with some to a frame is never a frame, and some hundred of its vertices. No
// bound; it says whether more moments are wanted of what nothing is proven of. O(#moments).
double sag_between_moments(const FilmStrip& strip);

} // namespace trivar
