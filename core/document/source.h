// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/voxel_shape.h"
#include "core/files/read_model.h"
#include "core/tetrahedra/simplex_sheet.h"
#include "core/tetrahedra/tetrahedra_shape.h"
#include "core/text/text_shape.h"

#include <glm/glm.hpp>
#include <string>
#include <variant>

namespace trivar {

// An ImportedFile is the file from which an object's shape comes, named relative to the scene
// file's folder; the hash says which content was meant.
struct ImportedFile {
    std::string path, hash;
    UpAxis up = UpAxis::automatic;
    double scale = 1;
    int subdivisions = 0; // Catmull-Clark levels, 0..6
    bool operator==(const ImportedFile&) const = default;
};
struct PlaneShape {
    glm::dvec2 size{4};
    glm::ivec2 segments{1};
    bool operator==(const PlaneShape&) const = default;
};
struct BoxShape {
    glm::dvec3 size{1};
    glm::ivec3 segments{8};
    bool operator==(const BoxShape&) const = default;
};
struct SphereShape {
    double radius = 0.5;
    int segments = 64, rings = 32;
    bool operator==(const SphereShape&) const = default;
};
struct CylinderShape {
    double radius = 0.5, height = 1;
    int segments = 64, stacks = 16;
    bool operator==(const CylinderShape&) const = default;
};
struct TorusShape {
    double radius = 0.5, tube = 0.2;
    glm::ivec2 segments{96, 48};
    bool operator==(const TorusShape&) const = default;
};
struct MoebiusShape {
    double radius = 0.5, width = 0.3;
    glm::ivec2 segments{128, 12};
    bool operator==(const MoebiusShape&) const = default;
};
struct TeapotShape {
    double height = 1;
    int resolution = 12;
    bool operator==(const TeapotShape&) const = default;
};
// A LatticeShape is a box of control points that deforms its contents: its children, as those of a
// group.
struct LatticeShape {
    glm::dvec3 size{1};   // metres along X, Y and Z; its middle is the origin
    glm::ivec3 grid{4};   // control points along X, Y and Z
    glm::ivec3 orders{4}; // 2..6 each, at most as many as there are control points
    bool operator==(const LatticeShape&) const = default;
};
// A HeightShape is a square sheet whose points stand as high as a picture is bright
// (core/mesh/height_sheet.h): a tile that displaces what it covers.
enum class HeightsLie { face, uv };
struct HeightShape {
    std::string image = {}, image_hash = {}; // named as an ImportedFile is
    double size = 1;                         // metres
    double height = 0.1;                     // metres from black to white
    double level = 0;                        // the brightness that stays on the ground
    int segments = 64;                       // along each side
    bool repeats = true;  // the picture goes on over its border, so that copies fit
    HeightsLie lies = {}; // what the picture lies over where it covers: each tile, or all UVs
    bool operator==(const HeightShape&) const = default;
};
struct GroupShape {
    bool operator==(const GroupShape&) const = default;
}; // no shape: a parent for others
using Source =
    std::variant<GroupShape, ImportedFile, PlaneShape, BoxShape, SphereShape, CylinderShape,
                 TorusShape, MoebiusShape, TeapotShape, TextShape, LatticeShape, HeightShape,
                 VoxelShape, TetrahedraShape, SimplexSheetShape>;

// Whether a source is a volume that deforms its contents.
inline bool bends_others(const Source& source)
{
    return std::holds_alternative<LatticeShape>(source) ||
           std::holds_alternative<TetrahedraShape>(source);
}

// Whether a source is a parent for others: a group, or a volume round them.
inline bool holds_others(const Source& source)
{
    return std::holds_alternative<GroupShape>(source) || bends_others(source);
}

} // namespace trivar
