// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/voxel_shape.h"
#include "core/files/read_model.h"
#include "core/tetrahedra/simplex_sheet.h"
#include "core/tetrahedra/tetrahedra_shape.h"
#include "core/text/text_shape.h"

#include <glm/glm.hpp>
#include <string>
#include <string_view>
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

enum class KindIcon { mesh, volume, tetrahedra, group };

// An ObjectKind says what the objects of one kind are called and what can be done with them.
struct ObjectKind {
    std::string_view type = "Primitive"; // what the outliner and its filter call it
    KindIcon icon = KindIcon::mesh;
    bool has_shape = true;      // false: there is nothing to evaluate or to lay on a stroke
    bool has_surface = true;    // triangles of its own, for steps, tiles, cuts and strokes
    bool holds_others = false;  // it is a parent for others, as a group is
    bool bends_others = false;  // it is a volume that deforms what it holds
    bool has_cage = false;      // control points to shape, on a stroke or not
    bool takes_material = true; // one material over all of it
    bool has_clips = false;     // of its file, to play
    bool has_curves = false;    // its file may have lines
    bool has_levels = false;    // it is volume data
    bool is_flat = false;       // nothing goes round it
    bool has_rows = false;      // the inspector has rows of its own for its numbers
};
template <class Shape> inline constexpr ObjectKind object_kind{};
template <>
inline constexpr ObjectKind object_kind<GroupShape>{.type = "Group",
                                                    .icon = KindIcon::group,
                                                    .has_shape = false,
                                                    .has_surface = false,
                                                    .holds_others = true,
                                                    .takes_material = false};
template <>
inline constexpr ObjectKind object_kind<ImportedFile>{
    .type = "Model", .has_clips = true, .has_curves = true, .has_rows = true};
template <> inline constexpr ObjectKind object_kind<PlaneShape>{.is_flat = true};
template <> inline constexpr ObjectKind object_kind<TextShape>{.type = "Text", .has_rows = true};
template <>
inline constexpr ObjectKind object_kind<LatticeShape>{.type = "Lattice",
                                                      .icon = KindIcon::volume,
                                                      .has_surface = false,
                                                      .holds_others = true,
                                                      .bends_others = true,
                                                      .has_cage = true,
                                                      .takes_material = false};
template <>
inline constexpr ObjectKind object_kind<VoxelShape>{
    .type = "Volume data", .icon = KindIcon::volume, .has_levels = true, .has_rows = true};
template <>
inline constexpr ObjectKind object_kind<TetrahedraShape>{.type = "Tetrahedra",
                                                         .icon = KindIcon::tetrahedra,
                                                         .has_surface = false,
                                                         .holds_others = true,
                                                         .bends_others = true};

} // namespace trivar
