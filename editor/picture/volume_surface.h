// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/ffd/guard.h"
#include "core/ffd/lattice.h"
#include "gpu/picture.h"
#include "ui/palette.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trivar {

// The faces of a volume as triangles, finer along the stroke.
struct VolumeSurface {
    std::vector<glm::dvec3> points, uvw;  // world; on [0, 1]^3
    std::vector<std::uint32_t> triangles; // three points each, anticlockwise from outside
};
VolumeSurface volume_surface(const Lattice& volume);

// FoldSurfaces are the faces of the cells that are proven bad, unknown or not judged, a few
// triangles each; of many cells, and of those not judged, only the outer faces of all of them
// together.
struct FoldSurfaces {
    VolumeSurface bad, unknown, allowed;
};
FoldSurfaces fold_surfaces(const Lattice& volume, const CellVerdicts& verdicts);

// The faces of a slice across the stroke, three cells long, with the given u in the middle cell.
VolumeSurface slice_at(const Lattice& volume, double u);

// An OnVolume is where a ray first meets the faces, on either side. O(#triangles).
struct OnVolume {
    glm::dvec3 p_world, uvw;
};
std::optional<OnVolume> on_volume(const VolumeSurface& surface, const Ray& ray);

gpu::Translucent veil_of(const VolumeSurface& surface, ui::Color color);

} // namespace trivar
