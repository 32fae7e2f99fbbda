// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/cast_image.h"
#include "gpu/color_map.h"
#include "gpu/ffd/deformed_meshes.h"
#include "gpu/mirror.h"
#include "gpu/picture.h"
#include "gpu/tiles/tile_mirror.h"
#include "gpu/volume_mirror.h"

namespace trivar::gpu {

// A SceneItem is an instance ready to be drawn. Scene space is world space moved to the middle of
// the scene, so that single precision suffices wherever in the world the scene lies.
struct SceneItem {
    const MirroredMesh* mesh;
    const MirroredEdges* edges;           // null unless the edges are drawn
    Ref<std::vector<Material>> materials; // null: the default material
    glm::mat4 to_scene;
    glm::mat3 normal_to_scene;
    bool mirrored; // the matrices turn faces round
    int id;
    float opacity;
    std::optional<glm::vec3> flat_color; // sRGB; see Instance
    glm::vec3 lo, hi;                    // box in scene space
    float extent;                        // size of the item, or of one of its copies
    const MirroredCopies* copies;        // null: it is drawn once, by the matrices
    // the copies that are drawn: either all or none of them turn faces round
    int first_copy, copy_count;
    const Buffer* values;                  // one per vertex, or null
    bool values_by_copy;                   // the copies' values are used in place of these
    const Buffer* rest;                    // the positions that solid materials follow, or null
    glm::vec4 rest_middle;                 // of `rest`, and 1 / radius
    int turned_about;                      // axis of `rest`; see turning_axis()
    const DeformedMesh* deformed_as_drawn; // null: it is not deformed in one phase
    // Passes that show it, and maps of shadows, draw it; of tiles these are different items, as
    // maps want also what the camera does not see.
    bool seen = true, casts = true;

    const Material& material(std::uint32_t index) const;
    // Whether a part lets things behind it shine through.
    bool see_through(const MirroredMesh::Part& part) const;
    // Whether it is the skin of bodies without gaps, whose backs are seen only from within (or
    // where a deformation folds it).
    bool is_body() const;
    bool shows_values() const { return values || values_by_copy; }
    // Returns how many times it is drawn; of tiles, how many of them are seen.
    int drawn_count() const;
};

// A CastItem is a volume ready to be cast.
struct CastItem {
    Ref<Casting> data;
    const MirroredVolume* mirrored; // null: it is cast on the processor
    int id;
    glm::mat4 to_voxels;              // of scene space
    CastView view;                    // without what follows from the frame
    std::array<glm::vec3, 8> corners; // of the box, in scene space
};

struct Scene {
    glm::dvec3 origin_world{0};
    std::vector<SceneItem> items;    // one per instance, or two where some of its copies mirror
    std::vector<Box> curve_boxes;    // world; of the picture's finite curves
    std::vector<CastItem> volumes;   // the farthest first
    std::vector<SceneItem> outlined; // what is outlined of it: the same items, or some copies
    std::vector<std::shared_ptr<const MirroredCopies>> own_copies; // of the outlined copies
    glm::vec3 lo{0}, hi{0}; // of all items and curves; unset where there are none
    float ground_z = 0;     // the lowest point of the scene; with a grid at most Z 0
    float radius = 1;       // half the diagonal
    std::array<glm::vec4, map_steps + 1> map_colors{};
    glm::vec4 map_range{0}; // values.glsl
};

// A CasterKey identifies the inputs of the maps that do not depend on the camera: equal keys mean
// equal maps.
struct CasterKey {
    struct Caster {
        std::uint64_t mesh_serial;
        glm::mat4 to_scene;
        Ref<std::vector<Material>> materials;
        std::uint64_t copies_serial; // 0: none
        int first_copy;
        bool operator==(const Caster&) const = default;
    };
    std::vector<Caster> casters;
    float ground_z = 0;
    bool operator==(const CasterKey&) const = default;
};
CasterKey casters_of(const Scene& scene);

// Uploads what is missing; volumes only with a mirror for them. Instances without a mesh, without
// triangles or with a matrix that is not finite are left out.
Scene scene_of(const Picture& picture, Mirror& mirror, const DeformedMeshes& deformed,
               const TileMirror& tiles, VolumeMirror* volumes);

} // namespace trivar::gpu
