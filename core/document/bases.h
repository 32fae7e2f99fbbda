// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>

namespace trivar {

// The objects on whose shapes an object's own depends: what its stroke lies on, what its tiles are
// painted on, what these are mixed with, what they become, what parts it, and what opens its
// incisions. An id may come twice.
std::vector<Id> bases_of(const Object& object);

// The object with other bases in place of its own; 0 takes one away: what lay on it lies on the
// rest, and its stroke stays in the world if nothing else carries it; its tiles are mixed with the
// rest, the rest part it, and its incisions have no blade.
Object with_bases(Object object, const std::function<Id(Id)>& other);

} // namespace trivar
