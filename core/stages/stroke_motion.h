// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"
#include "core/ffd/part.h"

#include <string>
#include <vector>

namespace trivar {

// A Support is a part of an object that a stroke may fall on, in the space in which the stroke was
// drawn.
struct Support {
    Id id = 0;
    Part part;
    Ref<Mesh> rest;             // its mesh before a pose or a volume moves the vertices; or null
    glm::dmat4 own_to_drawn{1}; // from its object's own space
    bool operator==(const Support&) const = default;
};

// A StrokeMotion says how an attached stroke follows its hosts. The stroke is laid in the space
// where it was drawn, with its hosts as they stood then, except for changes that are no motion; the
// result is moved to the world by the hosts' motion since then.
struct StrokeMotion {
    glm::dmat4 to_world{1}; // turns, scales evenly and shifts
    Sketch sketch;          // as its samples go with their hosts; as drawn where these only moved
    std::vector<Support> supports;
    std::vector<std::string> notices;
    bool shown = true; // else there is nothing now that carries it
    bool moved() const { return to_world != glm::dmat4(1); }
};

} // namespace trivar
