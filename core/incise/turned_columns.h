// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/runs.h"

namespace trivar {

// Below a cut through the body columns have the smoothed directions of their run; those of a run
// that is `parallel` have one. Then they lean as the cuts do that meet there, as far as all faces
// see them from outside.
SlitColumns columns_of(const std::vector<SlitRun>& runs, const std::vector<char>& parallel,
                       const SlitDrawing& drawing, const Inward& inward,
                       std::span<const Incision> incisions);

} // namespace trivar
