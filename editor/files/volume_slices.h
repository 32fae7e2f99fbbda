// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/files/volume_offer.h"

namespace trivar {

// The middle slices of data as they will stand in the scene: from its top, its front and its side.
std::array<VolumeSlice, 3> turned_slices(const VolumeOffer& offer);

} // namespace trivar
