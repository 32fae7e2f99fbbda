// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <glm/glm.hpp>

namespace trivar {

// Paints a handle that is pulled along a direction: an arrow head that looks there, with a halo.
void paint_arrow_head(const ui::Theme& theme, glm::vec2 at, glm::vec2 direction, float radius,
                      ui::Color color);

} // namespace trivar
