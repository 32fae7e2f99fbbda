// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/ref_pool.h"
#include "core/incise/incised.h"
#include "core/incise/slit_skin.h"

namespace trivar {

struct InciseOptions {
    int rows = 4; // of wall triangles from the skin down to the deepest floor
    // The materials of the walls from the skin down. Empty: walls look as the skin above them.
    std::vector<WallLayer> layers = {};
    bool guarded = true; // depths and openings stay such that no wall meets another
    double reach = 0.01; // of the skin's diagonal: strokes are looked for so far off the skin
};

// Cuts a skin. An incision that cannot be cut is left out, and its outcome says why. A closed skin
// stays closed and 2-manifold, with the same Euler number; seams stay and none is made; vertices of
// the mesh keep their numbers and bits.
//   skin        made ready once for a mesh
//   incisions   units of the mesh; of two in each other's way the later one gives way
// Cost: that of the region of the cuts, and one copy of the arrays; cuts in each other's way are
// tried again, shallower and narrower, for a counted number of looks at triangles, a second or two.
// The same bits for any number of threads. Generalizes the one slit in one patch of [Schein,
// thesis, 6.8]; docs/incise.md tells the steps.
IncisedMesh incise(const SlitSkin& skin, std::span<const Incision> incisions,
                   const InciseOptions& options = {});
// Cuts a skin into memory that is used again.
//   made      lends the mesh, in the memory of one that nobody has any more
//   progress  told of each attempt; its throw ends the work
IncisedMesh incise(const SlitSkin& skin, std::span<const Incision> incisions,
                   const InciseOptions& options, RefPool<Mesh>& made,
                   const Progress& progress = {});

} // namespace trivar
