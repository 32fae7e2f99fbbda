// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

enum class CutKeep { both, above, below };

// A PlainCut cuts an object in two where a plane, or a surface above a plane, goes through it. It
// stands in the object's own space, in that space's units, and rides with the object. "Above" is
// where the normal points.
struct PlainCut {
    glm::dvec3 point{0};        // of the plane
    glm::dvec3 normal{0, 0, 1}; // not 0; its length does not count
    // A stroke over the plane, by (way along `along`, height over the plane), ways ascending: a
    // smooth curve goes through these points and straight on beyond its ends. Empty: the plane
    // cuts. The curve is swept along normal x along, away from the eye.
    std::vector<glm::dvec2> stroke = {};
    glm::dvec3 along{1, 0, 0};
    // How far before the plane's point the eye was: lines through it sweep the curve. 0: parallel
    // lines do.
    double eye = 0;
    CutKeep keep = CutKeep::both;
    double gap = 0; // metres in the world between the halves; each moves by half of it
    bool operator==(const PlainCut&) const = default;
};

// Cutting says where an object is cut, one cut after the other through all pieces.
struct Cutting {
    std::vector<PlainCut> cuts;
    bool capped = true;             // the pieces are closed
    Filling inside = Filling::none; // what the caps show; none: the object's first material
    double tolerance = 1e-3;        // metres between the cut and a curved cut surface, at most
    bool operator==(const Cutting&) const = default;
};

} // namespace trivar
