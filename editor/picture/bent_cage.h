// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

namespace trivar {

// The volume of an object with its control points where the lattices that it stands in take them,
// from the inside out: as it is seen. Without such lattices, or where it has more than 20,000 of
// them, it is the volume itself. O(#control points) for each lattice. The object must have a
// volume.
Ref<Lattice> bent_cage(const Evaluation& evaluated, const Document& document,
                       const EvaluatedObject& of);

} // namespace trivar
