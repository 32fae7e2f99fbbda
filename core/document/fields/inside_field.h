// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

// The field of what caps show, of all that opens an object.
void inside_field(auto& inside, auto&& field)
{
    field("inside", inside, "a pattern that fills it, seen where it opens; none: its own material",
          any_value.called("Inside"));
}

} // namespace trivar
