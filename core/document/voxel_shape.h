// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/surfacing.h"
#include "core/document/volume_casting.h"
#include "core/document/volume_reading.h"
#include "core/field/field_spline.h"
#include "core/field/level_side.h"
#include "core/level/tetrahedra_fit.h"
#include "core/lines/ink.h"
#include "core/lines/more_lines.h"

#include <string>
#include <vector>

namespace trivar {

// A VoxelLevel is a level of volume data that is shown: by its surface, by its lines, or by both.
struct VoxelLevel {
    std::string name = {}; // empty: by its value
    double value = 0;      // of the data, in their own unit
    bool hidden = false;
    bool surface = true;
    Surfacing look = {}; // of the surface
    bool lines = true;
    LineStyle ink = {};
    bool certified = false; // lines at rest and in files are proven to lack nothing above 1/8 voxel
    MoreLines more = {};
    bool operator==(const VoxelLevel&) const = default;
};

// A VoxelShape is volume data from a file or a folder, as a function over its grid, with the levels
// that are shown. Each level is a closed mesh, so that whatever is done with a mesh can be done
// with it.
struct VoxelShape {
    std::string path = {}, hash = {}; // named as an ImportedFile is
    double scale = 1;                 // metres of the scene per metre of the data
    FieldOrder order = FieldOrder::cubic;
    FieldSpline spline = FieldSpline::interpolating;
    int coarsen = 1; // number of samples along each axis of which one is made; 1: all are kept
    int blur = 0;    // number of times that (1 2 1)/4 is applied to the samples along each axis
    LevelSide body = LevelSide::above; // on which side of its level a body is
    // The corners of the box of the data that is shown, by whatever, as shares of the grid along
    // its axes; the samples nearest to them count.
    glm::vec3 crop_low{0}, crop_high{1};
    std::vector<VoxelLevel> levels = {};
    TetrahedraFit fit = {}; // levels are those of the fit, and their lines those of its surface
    VolumeCasting casting = {};
    VolumeReading reading = {};
    bool operator==(const VoxelShape&) const = default;
};

} // namespace trivar
