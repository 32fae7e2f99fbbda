// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"
#include "core/stages/simplex_bending.h"

#include <map>
#include <vector>

namespace trivar {

// A BendingVolume bends objects in the world: a lattice, or the stroke on which one lies.
struct BendingVolume {
    Ref<Lattice> volume;
    Embedding embedding; // from the world
    // Set for the volume of a stroke, which continues straight beyond its ends, as wide and as high
    // as the objects in it. A lattice moves points outside of it with its nearest side.
    bool goes_on = false;
    // A volume of tetrahedra in place of the lattice, which is null then; no value: it is a
    // lattice.
    std::optional<TetrahedraInWorld> tetrahedra = {};
    bool operator==(const BendingVolume&) const = default;
};
BendingVolume bending_volume(const LatticeStroke& stroke);

// The volumes of the lattices in which an object stands and of those that bend these, in the order
// in which they bend it, as far as they are in `done`.
std::vector<BendingVolume> volumes_round(const Document& document, Id id,
                                         const std::map<Id, Ref<EvaluatedObject>>& done);

// Returns a volume as far as it reaches for objects in a box of its parameters.
Ref<Lattice> reaching(const BendingVolume& volume, const Box& uvw);

// A lattice with its control points where the volumes take them, one after the other, worked out
// when it is first asked for: O(number of control points) per volume. A lattice of more than 20,000
// control points stays as it is.
Ref<Lazy<Ref<Lattice>>> bent_cage(Ref<Lattice> cage, std::vector<BendingVolume> volumes);

} // namespace trivar
