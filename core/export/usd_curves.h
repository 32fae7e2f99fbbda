// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/curve_strips.h"
#include "core/files/growing_file.h"

namespace trivar {

std::string usd_time(const Film& film, std::size_t moment);

// Adds the strip as linear BasisCurves in the world, one per material of its lines, with time
// samples of its points where it does not rest. `number` is the number of the first of them;
// returns the number for the next addition.
std::size_t add_usd_curves(GrowingFile& file, const Film& film, const CurveStrip& strip,
                           std::size_t number, std::size_t first_material);

} // namespace trivar
