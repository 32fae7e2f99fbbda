// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/evaluation/bending.h"
#include "core/placement/shaper.h"

namespace trivar {

// The volume of one lattice, again and again while its box, its steps or its place change.
class BoxVolume {
public:
    // In the world. Stage: shape.
    Ref<ShapedVolume> operator()(const LatticeShape& shape,
                                 const std::vector<Ref<VolumeEdit>>& shaping,
                                 const glm::dmat4& to_world, Timings& timings,
                                 const Progress& progress);

private:
    LatticeShape shape_;
    Ref<Placement> at_rest_;
    std::vector<Ref<VolumeEdit>> shaping_;
    Shaper shaper_;
    Ref<ShapedVolume> shaped_; // about the origin
    glm::dmat4 to_world_{1};
    Ref<ShapedVolume> mapped_;
};

// Ids of the lattices that an object stands in, the innermost first.
std::vector<Id> lattices_round(const Document& document, Id id);

// Bends the parts of one object by the lattices that it stands in, one after the other, each of
// what the one before left. What lies in a volume already is deformed at once to be bent further.
class InLattices {
public:
    std::vector<Part> operator()(std::vector<Part> parts,
                                 const std::vector<Ref<ShapedVolume>>& lattices);

private:
    std::vector<Bending> bendings_;
};

} // namespace trivar
