// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/base/render_settings.h"
#include "core/mesh/part_key.h"
#include "core/mesh/pose.h"
#include "core/patches/tile_set.h"
#include "gpu/cast_volume.h"
#include "gpu/copy.h"
#include "gpu/curve.h"
#include "gpu/ffd/stage.h"
#include "gpu/shader_source.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trivar::gpu {

// An Instance says what to draw, by value. Meshes are uploaded once and kept by Ref identity.
struct Instance {
    Ref<Mesh> mesh;
    glm::dmat4 to_world{1};
    Ref<std::vector<Material>> materials;
    int id = 0; // what pick() returns; 0: not pickable
    // distinguishes instances of this id; id and part identify the instance in the next picture
    PartKey part = {};
    bool highlighted = false; // has an outline
    float opacity = 1;        // below 1: a ghost, for previews
    // sRGB. It is of this colour alone, as paper: it takes no light and throws no shadow.
    std::optional<glm::vec3> flat_color = {};
    Ref<Mesh> rest = {}; // the mesh before it was deformed, vertex by vertex: for solid materials
    Ref<std::vector<float>> values = {}; // one per vertex: see value_colors
    // The places at which one call draws the mesh many times. Null: it is drawn once, at to_world.
    Ref<std::vector<Copy>> copies = {};
    // The places in `copies` that have an outline although the instance is not highlighted.
    std::vector<std::uint32_t> outlined_copies = {};
    // The patches over which the vertex stage bends `mesh`, which is that of their model, before
    // to_world: one call draws what is seen of the tiles, small ones with fewer triangles. Null: it
    // is not bent so. Then neither copies nor a pose nor stages are read.
    Ref<TileSet> tiles = {};
    // The pose that is applied to `mesh` before the stages; its result is not read. Null: none.
    Ref<PosedMesh> posed = {};
    // The volumes that deform `mesh`, one after another, before to_world; `rest` is then ignored.
    std::vector<Stage> stages = {};
};

// ValueColors say how the values of instances become colours; see gpu/color_map.h.
struct ValueColors {
    bool diverging = true; // lightest in the middle; false: from dark to light
    bool ratios = true;    // shown by log2; values of 0 and less are hatched
    // The range of the shown values; values beyond have the colour of the nearest end.
    glm::vec2 range = glm::vec2(-1, 1);
};

// A Line is drawn over the scene as a help for work, thin and dashed where something hides it.
struct Line {
    std::vector<glm::vec3> points; // world
    glm::vec4 color{1};            // linear
    float width_px = 2;
};

// A Translucent is a see-through surface over the scene: the faces of a volume, a strip, a tool. It
// is unlit but for a rim where it has normals and turns away. Seen from behind it is fainter, and
// more so behind solid things. Their order does not matter.
struct Translucent {
    std::vector<glm::vec3> points;        // world
    std::vector<glm::vec4> colors;        // linear, with coverage; one per point, or one for all
    std::vector<std::uint32_t> triangles; // three points each, anticlockwise from the front
    std::vector<glm::vec3> normals = {};  // one per point, or empty: flat, without a rim
};

// A Backdrop is the background of a picture. Colours are display-linear; the share of a line is a
// share of the encoded colour, so that a tenth looks like a tenth on any ground.
struct Backdrop {
    glm::vec3 top{0}, middle{0}, bottom{0};
    float corners = 0.55f; // how much darker the corners are
    float line_px = 1;     // width of the grid's finest lines
    glm::vec4 grid{0, 0, 0, 0.041f}, grid_major{0, 0, 0, 0.103f}, axis_x{0}, axis_y{0}, axis_z{0};
    bool operator==(const Backdrop&) const = default;
};

// An Outline surrounds highlighted instances; linear.
struct Outline {
    glm::vec4 color{1}, halo{0, 0, 0, 0.55f};
    float width_px = 2, halo_px = 1.5f;
    bool operator==(const Outline&) const = default;
};

// An EdgeStyle draws the edges of faces, where the settings ask for them. Linear.
struct EdgeStyle {
    glm::vec3 color{0.012f, 0.014f, 0.02f};
    bool alone = false; // for instances of which only edges are drawn: as dark as on solid ones
    bool operator==(const EdgeStyle&) const = default;
};

struct Picture {
    Camera camera;
    RenderSettings settings;
    std::vector<Instance> instances;
    std::vector<Curve> curves;
    std::vector<CastVolume> volumes;
    std::vector<Translucent> translucent;
    std::vector<Line> lines;
    Outline outline;
    EdgeStyle edges = {};
    // If set, colours show the values of instances in place of materials; instances without values
    // are grey.
    std::optional<ValueColors> value_colors;
    DeformBy deform_by = DeformBy::two_phases; // instances that have stages
    int samples = 4;                           // of antialiasing
    bool draft = false; // leave out the slow parts while something is being dragged
    bool deep = false;  // drawn with 16 bits a channel, and not dithered to 8
    double scale = 1;   // of the size: a draft drawn smaller is shown enlarged
    // Lines on Z 0, for orientation while working; in an orthographic view along an axis, on the
    // plane through the origin that it faces. The ground is then no higher than Z 0.
    bool grid = false;
    std::optional<Backdrop> backdrop = {}; // replaces the one of the look
    Ref<ShaderTexts> shaders = {};         // a developer's, in place of the embedded ones
};

} // namespace trivar::gpu
