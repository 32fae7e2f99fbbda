// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/lines/mesh_drawing.h"
#include "core/scene_lines/hiding_surfaces.h"
#include "core/scene_lines/line_scene.h"
#include "core/scene_lines/seen_tiles.h"

#include <limits>
#include <map>
#include <tuple>

namespace trivar {

// ObjectLines is the lines of one object of a scene.
struct ObjectLines {
    // One level of volume data, or one kind of line of one part.
    struct Layer {
        DrawingLayer drawing;   // called by the level or by the kind
        glm::dmat4 to_world{1}; // of the places that its lines have in space
        glm::dmat4 to_image{1}; // of the same, to pixels and depth: how they were inked
        // Metres: triangles of the same object that lie less far before a seen line do not hide it.
        // Unbounded where rays have found what hides it; they do not look for quick lines of one
        // level among several.
        double own_reach = std::numeric_limits<double>::infinity();
    };
    int object = 0; // its id
    std::string name;
    std::vector<Layer> layers;
    ProofGaps gaps; // of levels whose lines are certified
};

// The lines of a scene.
struct SceneLines {
    std::vector<Ref<ObjectLines>> objects;
    ProofGaps gaps;                   // of all
    std::vector<std::string> notices; // of what is not drawn: a sentence each, with its object
};

// full: as files have them. quick: what a window can draw while it moves: no object hides the lines
// of another, tiles and intersections have none, and none has a proof.
enum class LineEffort : std::uint8_t { full, quick };

struct LineOptions {
    LineEffort effort = LineEffort::full;
    // The ids of the lines of a layer of volume data, kept from view to view. None: where a level
    // shows a share of its lines, those stay that the drawer drew before.
    std::function<LineIds&(const std::string& object, const std::string& layer)> ids = {};
    // See LevelDrawingOptions, for levels of volume data.
    bool levels_hide_each_other = false;
    int certified_depth = -1, dash_rows = 0;
    Progress progress = {}; // from any thread
};

// A LineDrawer draws the lines of scenes, one after another: of objects that are drawn in lines,
// and of levels of volume data. Surfaces that are shown hide the lines of other objects, be they
// drawn in lines or not; of volume data also those of other levels. It keeps what belongs to no
// view. Not thread-safe. The first view costs 0.4 us per triangle of all objects, each further one
// 10 ns per triangle and 2 us per point of the lines; those of volume data as draw_levels() says.
class LineDrawer {
public:
    // Throws Cancelled.
    SceneLines operator()(const LineScene& scene, const LineOptions& options = {});

private:
    // A mesh of an object as it stands in the world.
    struct PlacedMesh {
        Ref<Mesh> mesh;
        glm::dmat4 to_world{1};
        int number = 0;      // in its object's shape
        double size = 0;     // metres, of one tile where they are tiles
        float copy_size = 0; // see shaped_mesh()
        bool operator==(const PlacedMesh&) const = default;
    };
    using PlacedMeshes = std::vector<PlacedMesh>;
    struct Work; // on one scene

    PlacedMeshes meshes_of(const LineScene::Object& object, Work& work);
    RayScene::Entry entry_of(const PlacedMesh& mesh);
    void find_surfaces(Work& work);
    void draw_meshes(ObjectLines& out, std::size_t number, Work& work);
    void draw_levels(ObjectLines& out, std::size_t number, Work& work);
    void draw_intersections(ObjectLines& out, std::size_t number, Work& work);
    Ref<IntersectionLines> intersections(const PlacedMeshes& a, const PlacedMeshes& b);
    Ref<TriangleBody> body_of(const PlacedMeshes& meshes);

    // A LineMemory keeps lines of an object's levels from view to view, by layer.
    struct LineMemory {
        std::map<std::string, LineIds> ids;
        std::map<std::string, std::vector<std::uint64_t>> kept;
    };
    using ShapeKey = std::tuple<Ref<Mesh>, float, MoreLines, glm::mat3>;
    Recent<ShapeKey, Ref<ShapedMesh>> shapes_;
    Recent<Ref<Mesh>, Ref<RayMesh>> rays_;
    Recent<std::tuple<Ref<TileSet>, glm::dmat4, Camera>, SeenTiles> tiles_{8};
    Recent<PlacedMeshes, Ref<TriangleBody>> bodies_;
    Recent<std::pair<PlacedMeshes, PlacedMeshes>, Ref<IntersectionLines>> intersections_;
    Recent<std::pair<LineScene::Object, Camera>, Ref<ObjectLines>> quick_{16};
    std::map<int, LineMemory> memories_; // by object, of those that show a share of their lines
};

} // namespace trivar
