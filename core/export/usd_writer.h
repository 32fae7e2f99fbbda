// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/export/curve_strips.h"

namespace trivar {

// A text file of Universal Scene Description (.usda): Z up, metres, time codes are frames. What a
// volume or a pose moves has time samples of its points and normals, in the world; what moves as it
// is has them of its matrix; what is not always shown, of its visibility. Curves are linear
// BasisCurves, one for each material. Colours of materials, no pictures. The film has one moment a
// frame. The file is whole or not there. Throws Rejected and Cancelled.
void write_usda(const Film& film, const std::vector<CurveStrip>& curves, double frames_per_second,
                const std::string& path, const Progress& progress = {});

} // namespace trivar
