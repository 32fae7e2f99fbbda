// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/parameters.h"
#include "ui/widgets.h"

namespace trivar {

// Draws the field of a value that can have keys, by its kind: a number, a whole number, a list of
// choices or a box to tick. Numbers are in shown units, not in stored ones.
ui::Edit value_field(const ui::Theme& theme, Parameter& number, const ui::NumberStyle& style,
                     float width);

} // namespace trivar
