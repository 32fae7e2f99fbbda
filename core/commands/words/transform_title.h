// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"

namespace trivar {

// The title of a transform, by what differs: "Rotate Snake" "90 deg about Z".
StepTitle transform_title(const Transform& before, const Transform& after, const std::string& name);
// The turn from one rotation to another: "90 deg about Z", or just its angle.
std::string turn_words(const glm::dvec3& before_deg, const glm::dvec3& after_deg);
// "× 2", "× 2 along X".
std::string growth_words(const glm::dvec3& before, const glm::dvec3& after);

} // namespace trivar
