// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

#include <functional>

namespace trivar {

// Objects that stand far from the origin would lose detail where their vertices are worked out in
// the world in single precision. They are evaluated where they would stand near the origin,
// together with all on which they depend, and what comes out is carried to where they are: the
// vertices of each part stay near 0, and its to_world holds the place, in double precision.
class FarPlaces {
public:
    struct Near {
        Document document;                      // that was given, with far objects moved
        std::map<Id, glm::dvec3> moved_by = {}; // of those, the way back
    };
    // `order` are the ids to evaluate. Where nothing is far the document is the one that was given.
    // Equal objects that are moved alike are the same objects, call after call.
    Near operator()(const Document& document, const std::vector<Id>& order,
                    const std::function<const Shape&(Id)>& shape_of);

private:
    std::map<Id, Ref<Object>> moved_;
};

// A stage of an object where it stands by that much further on. `laid` says which objects lie on
// strokes: their own space goes along.
Stage moved_on(Stage stage, const glm::dvec3& by, Id id, const std::function<bool(Id)>& laid);

} // namespace trivar
