// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>
#include <string_view>

namespace trivar {

// An object on whose shape another one's depends, and what that is to it: what its stroke lies on,
// what its tiles are painted on, mixed with, masked by and turned into, what splits it, and what
// opens its incisions.
struct BaseUse {
    Id base = 0;
    std::string_view words; // "painted on"
};
std::vector<BaseUse> bases_of(const Object& object); // an id may come twice

// The object with other bases in place of its own; 0 takes one away: what lay on it lies on the
// rest, and its stroke stays in the world if nothing else carries it; its tiles are mixed with the
// rest, the rest part it, and its incisions have no blade. What a list names twice then is there
// once.
Object with_bases(Object object, const std::function<Id(Id)>& other);

} // namespace trivar
