// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/ref.h"
#include "core/document/voxel_shape.h"
#include "core/voxels/cropped.h"

namespace trivar {

struct Casting;
struct DrawnLevel;
struct LevelLines;
struct LevelMesh;
struct VolumeSummary;
class VoxelField;
struct VoxelGrid;

// Certified lines are proven to boxes of a voxel halved so often.
inline constexpr int certified_halvings = 3;

// A ShownVolume is volume data with the levels that an object shows of it and the data by which
// their lines are drawn. A level that is hidden is not in it.
struct ShownVolume {
    struct Level {
        std::size_t number = 0; // in VoxelShape::levels
        std::string name;
        Ref<LevelMesh> mesh;
        bool lines = false;
        LineStyle ink = {};
        bool certified = false; // its lines are wanted with a proof, and the field can have one
        MoreLines more = {};
        Ref<LevelLines> further = {};            // that `more` are found by; null: none of them
        Ref<std::vector<LevelMesh>> nearby = {}; // where only a share of the lines is drawn
        int surface = -1; // number of the shape's mesh that is its surface; -1: it shows none
    };
    Ref<VoxelField> field; // over the part of the data that is shown
    Ref<VoxelGrid> data;   // all of it, as it was read
    SampleBox part;        // which of all samples these are
    Ref<VolumeSummary> summary;
    LevelSide side = LevelSide::above; // of the bodies, as samples
    glm::dmat4 to_model{1};            // voxels of the part to the object's model
    std::vector<Level> levels;
    Ref<Casting> casting = {}; // of all data; null: they are not seen as a whole
    VolumeCasting seen_as = {};

    // The levels whose lines are drawn, for draw_levels(); they refer to those here.
    std::vector<DrawnLevel> drawn_levels() const;
    bool certifies() const;          // some of these lines with a proof
    glm::dmat4 all_to_model() const; // voxels of all data to the object's model
    Box cast_box() const;            // of what is cast, in these voxels; empty: nothing is
    // Returns the corners of the box round the cast volume and the levels with lines, in the world;
    // none: nothing is shown. O(#vertices of the levels).
    std::vector<glm::dvec3> seen_corners(const glm::dmat4& to_world) const;
};

} // namespace trivar
