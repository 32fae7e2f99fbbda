// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "tests/support/scenes/commands.h"

#include <string>

namespace trivar::testing {

// An incision over a ball of radius 1, straight between directions.
NamedIncision over_ball(const glm::dvec3& from, const glm::dvec3& to);
NamedIncision across_the_front(double opening = 1);
Document ball_to_incise();
Document incised_ball(double opening = 1);
Ref<EvaluatedObject> ball_in(const Document& document, double frame = 1);
std::string effects_of(const Document& document, double frame = 1);

} // namespace trivar::testing
