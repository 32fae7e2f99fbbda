// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/copied_splitting.h"
#include "core/commands/copied_tiling.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shade.h"
#include "core/commands/objects/shape.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/text.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"

#include <string>
#include <vector>

namespace trivar {

struct CopiedPlacement {
    Sketch sketch;
    PlacementParameters parameters;
    std::vector<KnownObject> onto;
    bool round = false;
    double level = 0;
    std::optional<Attachment> attach = {};
    std::optional<glm::dvec3> normal = {};
    bool operator==(const CopiedPlacement&) const = default;
};

// A CopiedObject is an object by itself, with its number in the scene from which it was copied.
struct CopiedObject {
    Id object = 0;
    std::string name;
    // At most one of these is set; none: a group.
    std::optional<ImportedFile> file;
    std::optional<PlaneShape> plane;
    std::optional<BoxShape> box;
    std::optional<SphereShape> sphere;
    std::optional<CylinderShape> cylinder;
    std::optional<TorusShape> torus;
    std::optional<MoebiusShape> moebius;
    std::optional<TeapotShape> teapot;
    std::optional<TextShape> text = {};
    std::optional<LatticeShape> lattice = {};
    std::optional<HeightShape> heights = {};
    std::optional<VoxelShape> voxels = {};
    std::optional<TetrahedraShape> tetrahedra = {};
    std::optional<SimplexSheetShape> sheet = {};
    Transform transform;
    Id parent = 0;
    bool hidden = false, locked = false;
    std::optional<Surfacing> material;
    std::optional<CopiedPlacement> placement;
    std::vector<VolumeEdit> shaping;
    std::optional<Travel> travel;
    std::optional<Playing> playing;
    std::optional<Refining> refining;
    std::optional<Simplifying> simplifying;
    std::optional<Unwrapping> unwrapping = {};
    std::optional<FaceShading> shading = {};
    std::optional<Incising> incising = {};
    std::vector<KnownObject> blades = {}; // of its incisions
    std::optional<CopiedTiling> tiling = {};
    std::optional<Cutting> cutting = {};
    std::optional<CopiedSplitting> splitting = {};
    std::optional<LineDrawing> line_drawing = {};
    std::vector<Track> tracks;
    bool operator==(const CopiedObject&) const = default;
};

template <> struct FieldsOf<CopiedPlacement> {
    static constexpr std::string_view told_as = "[placement](#placement)";
    static void fields(auto& p, auto&& field)
    {
        field("sketch", p.sketch, "the stroke; none if it lies round an object");
        field("parameters", p.parameters, "how it lies");
        field("onto", p.onto, "its hosts: other copies, or objects of the scene");
        field("round", p.round, "about the only one of onto, in place of a stroke");
        field("level", p.level, "metres from the widest circle of that object, or from its origin");
        field("normal", p.normal, "of the plane that cuts that object; left out: none does");
        field("attach", p.attach,
              "the hosts among onto that it is attached to, by the same numbers");
    }
};
template <> struct FieldsOf<CopiedObject> {
    static constexpr std::string_view told_as = "[object](#object)";
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "its id when it was copied, by which other copies name it",
              required.names_object());
        field("name", c.name, "its name, with a number if the name is taken", required);
        field("file", c.file,
              "file of an imported model; an object without file and shape is a group");
        field("plane", c.plane, "its shape, as of add_plane");
        field("box", c.box, "its shape, as of add_box");
        field("sphere", c.sphere, "its shape, as of add_sphere");
        field("cylinder", c.cylinder, "its shape, as of add_cylinder");
        field("torus", c.torus, "its shape, as of add_torus");
        field("moebius", c.moebius, "its shape, as of add_moebius");
        field("teapot", c.teapot, "its shape, as of add_teapot");
        field("text", c.text, "its shape, as of add_text");
        field("lattice", c.lattice, "its box of control points, as of add_lattice");
        field("heights", c.heights, "its shape, as of add_heights");
        field("volume_data", c.voxels, "its shape, as of add_volume");
        field("tetrahedra", c.tetrahedra, "its tetrahedra, as of add_tetrahedra", later);
        field("simplex_sheet", c.sheet, "its shape, as of add_simplex_sheet", later);
        field("transform", c.transform, "its transform, in its group if that is copied, too");
        field("parent", c.parent, "id of the copied group it is in, which comes before it; 0: none",
              any_value.names_object());
        field("hidden", c.hidden, "it is not in the picture");
        field("locked", c.locked, "it cannot be picked, moved or deleted by hand");
        field("material", c.material, "one material over all of it; left out: its own");
        field("placement", c.placement, "how it lies on a stroke");
        field("shaping", c.shaping, "what was done to its volume after that, step by step");
        field("travel", c.travel, "how it travels along its stroke");
        field("playing", c.playing, "how an imported model moves by a clip of its file");
        field("refining", c.refining, "how finely its triangles are split");
        field("simplifying", c.simplifying, "how its triangles are reduced");
        field("unwrapping", c.unwrapping, "how its texture coordinates are made");
        field("shading", c.shading, "where it looks smooth and where it shows edges", later);
        field("incising", c.incising, "where its skin is cut open");
        field("blades", c.blades,
              "the blades of its incisions: other copies, or objects of the scene", later);
        field("tiling", c.tiling, "how copies of it are painted on another object");
        field("cutting", c.cutting, "where it is cut in pieces");
        field("splitting", c.splitting, "what parts it, and how its halves are closed");
        field("line_drawing", c.line_drawing, "how it is drawn in lines", later);
        field("tracks", c.tracks, "its animated parameters with their keys", later);
    }
};

} // namespace trivar
