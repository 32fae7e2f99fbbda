// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"

namespace trivar {

// An estimate, not a bound, in metres, of how far a part is from even motion between two moments.
// It says whether a part of which nothing is proven wants more moments. Every second moment is
// compared, which is never a whole frame where there are several per frame, at some hundred
// vertices. O(#moments).
double sag_between_moments(const FilmStrip& strip);

} // namespace trivar
