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
    // The distance of the eye before the plane's point: lines through it sweep the curve. 0:
    // parallel lines do.
    double eye = 0;
    CutKeep keep = CutKeep::both;
    double gap = 0; // metres in the world between the halves; each moves by half of it
    // The state of the object when the cut was drawn: how far the part above each earlier cut then
    // stood off its place, in this space; the part below stood off as far the other way. So the cut
    // goes through each piece where it was seen, and a gap that changes later only moves pieces.
    // Missing: 0.
    std::vector<glm::dvec3> opened = {};
    // Set if it was drawn over an object that obstacles part, and cuts the parts.
    bool parted = false;
    // Returns whether it cuts: keys can take its direction away.
    bool cuts() const { return glm::length(normal) > 1e-9; }
    bool operator==(const PlainCut&) const = default;
};

// Returns how far a piece is off its place: by each offset if it is above that cut, and by as much
// the other way if it is below. Bit i of `sides`: above cut i; of `made`: there is such a cut.
inline glm::dvec3 off_by_sides(const std::vector<glm::dvec3>& offsets, unsigned sides,
                               unsigned made = ~0u)
{
    glm::dvec3 out(0);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        if ((made >> i & 1u) != 0) out += (sides >> i & 1u) != 0 ? offsets[i] : -offsets[i];
    return out;
}

// The same when a cut was drawn, in the cut's space.
inline glm::dvec3 drawn_off(const PlainCut& cut, unsigned sides, unsigned made)
{
    return off_by_sides(cut.opened, sides, made);
}

// Cutting says where an object is cut, one cut after the other through all pieces.
struct Cutting {
    std::vector<PlainCut> cuts;
    bool capped = true;             // the pieces are closed
    Filling inside = Filling::none; // what the caps show; none: the object's first material
    double tolerance = 1e-3;        // metres between the cut and a curved cut surface, at most
    bool operator==(const Cutting&) const = default;
};

} // namespace trivar
