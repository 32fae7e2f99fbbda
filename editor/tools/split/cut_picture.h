// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"
#include "gpu/picture.h"
#include "ui/theme.h"

namespace trivar {

// The surfaces that cut an object, see-through, and their borders, over what the object fills.
std::vector<gpu::Translucent> sheets_of(const EvaluatedObject& object, const Cutting& cutting,
                                        const ui::Theme& theme);
std::vector<gpu::Line> borders_of(const EvaluatedObject& object, const Cutting& cutting,
                                  const ui::Theme& theme);

} // namespace trivar
