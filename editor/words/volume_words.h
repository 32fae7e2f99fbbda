// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/overlap.h"
#include "core/placement/shaper.h"

#include <string>

namespace trivar {

// A step of shaping in words, for a list: "Press, Gaussian, radius 0.34 m".
std::string words_of(const VolumeEdit& edit);
// The same for a step that is done, with what was chosen then: "Mended, it was lowered".
std::string words_of(const VolumeEdit& edit, const Shaping& done);

// What is proven of a volume, as the end of a sentence: "folds nowhere, proven".
std::string words_of(const CellVerdicts& verdicts);
std::string words_of(const Overlap& overlap);

} // namespace trivar
