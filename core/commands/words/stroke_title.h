// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/object.h"

#include <optional>

namespace trivar {

// Describes a stroke that was carried as a whole, with its camera: moved, turned, scaled or lifted.
// It was turned if its ends go further about its middle than the middle goes, measured at its
// samples' hits on its hosts, else on the ground. Empty: the stroke did not change, or was drawn
// anew. O(number of samples).
std::optional<StepTitle> stroke_title(const PlacementStep& before, const PlacementStep& after,
                                      const std::string& name);

} // namespace trivar
