// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"
#include "gpu/picture.h"
#include "ui/theme.h"

namespace trivar {

// The walls of the openings, see-through, and lines along them and round the cut surfaces. World.
std::vector<gpu::Translucent> walls_of(const SplitField& field, const ui::Theme& theme);
std::vector<gpu::Line> lines_of(const SplitField& field, const ui::Theme& theme);

} // namespace trivar
