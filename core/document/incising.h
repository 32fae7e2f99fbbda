// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/surfacing.h"
#include "core/incise/incision.h"

#include <string>
#include <vector>

namespace trivar {

// A NamedIncision is one incision of an object. It stands in the space of the object's model at
// rest, in metres there.
struct NamedIncision {
    std::string name = {};
    bool hidden = false; // as if it were not there
    Incision cut = {};
    IncisionOpening opening = {};
    bool operator==(const NamedIncision&) const = default;
};

// The incision with its stroke from end to start, and all that runs along it.
inline NamedIncision reversed(NamedIncision incision)
{
    incision.cut = reversed(std::move(incision.cut));
    incision.opening = reversed(incision.opening);
    return incision;
}
// Its mirror image in the plane X = 0 of the model.
inline NamedIncision mirrored(NamedIncision incision)
{
    incision.cut = mirrored(std::move(incision.cut));
    return incision;
}

// An IncisionLayer is what walls show down to a depth, from that of the layer before.
struct IncisionLayer {
    std::string name = {};
    double depth = 0.01; // metres on the model; that of the last layer does not matter
    Surfacing look = {};
    bool operator==(const IncisionLayer&) const = default;
};

// Incising says where the skin of an object is cut open, before anything bends it.
struct Incising {
    std::vector<NamedIncision> cuts;
    std::vector<IncisionLayer> layers = {}; // from the skin down; none: walls look as the skin
    int rows = 4;                           // of faces from the skin to the deepest floor
    bool operator==(const Incising&) const = default;
};

} // namespace trivar
