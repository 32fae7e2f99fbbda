// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace trivar {

// Finds the first of a layer's base, the base of that, and so on, for which `has` is true: its
// steps apply to its tiles, too. 0: none, or the object is no layer.
template <class Has> Id base_that(const Document& document, const Object& layer, Has&& has)
{
    const Object* at = &layer;
    while (at->tiles) {
        const auto base = document.objects.find(at->tiles->base);
        if (base == document.objects.end()) return 0;
        at = (*base).second.get();
        if (has(*at)) return (*base).first;
    }
    return 0;
}

} // namespace trivar
