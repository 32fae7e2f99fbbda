// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/surfacing.h"
#include "core/incise/flap_place.h"
#include "core/incise/incision.h"

#include <string>
#include <utility>
#include <vector>

namespace trivar {

// A NamedIncision is one incision of an object. It stands in the space of the object's model at
// rest, in metres there.
struct NamedIncision {
    std::string name = {};
    bool hidden = false; // as if it were not there
    Incision cut = {};
    IncisionOpening opening = {};
    // An object that opens it: up to the place nearest to its origin, and no further than
    // `opening.to`. 0: none does.
    int blade = 0;
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

// A PeeledFlap is a flap between two incisions that cross, bent outward. The incisions are named by
// their numbers, the first is 1.
struct PeeledFlap {
    int first = 1, second = 2; // the lower number first
    IncisionSide side_of_first = IncisionSide::left, side_of_second = IncisionSide::left;
    // metres on the model by which its tip is raised while both incisions are quite open
    double lift = 0;
    bool same_place(const PeeledFlap& other) const
    {
        return first == other.first && second == other.second &&
               side_of_first == other.side_of_first && side_of_second == other.side_of_second;
    }
    bool operator==(const PeeledFlap&) const = default;
};
// The same flap with the lower number first.
inline PeeledFlap in_order(PeeledFlap flap)
{
    if (flap.first < flap.second) return flap;
    std::swap(flap.first, flap.second);
    std::swap(flap.side_of_first, flap.side_of_second);
    return flap;
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
    std::vector<PeeledFlap> flaps = {};
    bool operator==(const Incising&) const = default;
};

} // namespace trivar
