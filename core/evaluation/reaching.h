// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <vector>

namespace trivar {

// The volume as far as models at these places are on it, straight on beyond its ends or round once
// more.
Ref<Lattice> reaching(const Ref<Lattice>& volume, const Journey& journey,
                      const PlacementParameters& parameters,
                      const std::vector<Journey::Place>& places);

} // namespace trivar
