// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/placement/shaping.h"

#include <vector>

namespace trivar {

// A SheetLift moves the control points of a sheet that rest within a circle, less and less toward
// its rim.
struct SheetLift {
    glm::dvec2 at{0};
    double radius = 0.5;     // metres
    glm::dvec3 by{0, 0, .3}; // metres
    Decay decay = Decay::smooth;
    bool operator==(const SheetLift&) const = default;
};

// A SimplexSheetShape is a surface over a triangulated rectangle in z = 0, about the origin: the
// sum of the DMS basis functions of its triangles times control points in space.
struct SimplexSheetShape {
    glm::dvec2 size{2};  // metres
    glm::ivec2 boxes{2}; // along X and Y, of 2 triangles each
    int degree = 2;      // 1..3
    double spread = 0.15;
    bool clamped = true; // knots of the border are stacked
    int segments = 64;   // of the mesh, along each side
    std::vector<SheetLift> lifts = {};
    bool operator==(const SimplexSheetShape&) const = default;
};

// The mesh of a sheet, with exact normals; u and v go along X and Y. About 1 us per vertex. Throws
// Rejected as check() of its domain does.
Mesh simplex_sheet(const SimplexSheetShape& shape);

} // namespace trivar
