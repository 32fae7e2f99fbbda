// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"
#include "gpu/cast_volume.h"

#include <optional>

namespace trivar {

// Returns the volume of an object that is cast; nothing if it is no volume data, or shows none of
// them as a whole.
std::optional<gpu::CastVolume> cast_volume_of(const EvaluatedObject& object);

} // namespace trivar
