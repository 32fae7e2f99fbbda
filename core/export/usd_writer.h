// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/curve_strips.h"
#include "core/export/usd_instances.h"

namespace trivar {

// Writes a text file of Universal Scene Description (.usda): Z up, metres, time codes are frames. A
// part that a volume or a pose moves has time samples of its points and normals, in the world; a
// part that moves as a whole has time samples of its matrix; a part that is not always shown has
// time samples of its visibility. Curves are linear BasisCurves, one per material. Materials have
// colours and no pictures; where vertices have colours, these are the displayColor of the mesh,
// which its materials show. Instances are PointInstancers, whose prototype is the mesh below them.
// The film must have one moment per frame; `shown` is its strips or instanced(). The file is
// written completely or not at all. Throws Rejected and Cancelled.
void write_usda(const Film& film, const InstancedFilm& shown, const std::vector<CurveStrip>& curves,
                double frames_per_second, const std::string& path, const Progress& progress = {});

} // namespace trivar
