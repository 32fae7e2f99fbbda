// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/placement/journey.h"

#include <vector>

namespace trivar {

// Lengthens the volume as far as models at these places need it: straight on beyond its ends, or
// once more round.
Ref<Lattice> reaching(const Ref<Lattice>& volume, const Journey& journey,
                      const PlacementParameters& parameters,
                      const std::vector<Journey::Place>& places);

} // namespace trivar
