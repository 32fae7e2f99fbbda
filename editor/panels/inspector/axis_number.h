// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <string>

namespace trivar {

// A field for one number of a few, shown times a factor; it changes only by a hand.
template <class Real>
ui::Edit axis_number(const ui::Theme& theme, const std::string& id, Real& value, double factor,
                     const ui::NumberStyle& style, float width)
{
    double shown = static_cast<double>(value) * factor;
    const double was = shown;
    const ui::Edit edit = ui::number_field(theme, id, shown, style, width);
    if (shown != was) value = static_cast<Real>(shown / factor);
    return edit;
}

} // namespace trivar
