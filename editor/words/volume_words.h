// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/overlap.h"
#include "core/placement/shaper.h"

#include <string>

namespace trivar {

// A step of shaping in words, for a list: "Press, Gaussian, radius 0.34 m". `box`: the volume is a
// lattice's, whose axes are X, Y and Z.
std::string words_of(const VolumeEdit& edit, bool box = false);
// The part of a step that was done: where the guard stopped it, it has the amount let through. A
// press, a turn and a change of size are returned as they are.
VolumeEdit as_done(VolumeEdit edit, const Shaping& done);
// The same words for a step that is done, with what was chosen then.
std::string words_of(const VolumeEdit& edit, bool box, const Shaping& done);

// Words the facts that are proven of a volume, as the end of a sentence: "folds nowhere, proven".
std::string words_of(const CellVerdicts& verdicts);
std::string words_of(const Overlap& overlap);

} // namespace trivar
