// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/parameters.h"
#include "ui/widgets.h"

namespace trivar {

// The field of a value that can have keys, by its kind: a number, a whole one, a list of choices or
// a box to tick. Numbers are as they are shown, not as they are stored.
ui::Edit value_field(const ui::Theme& theme, Parameter& number, const ui::NumberStyle& style,
                     float width);

} // namespace trivar
