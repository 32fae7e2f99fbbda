// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/document/render_settings.h"
#include "core/mesh/part_key.h"
#include "core/mesh/pose.h"
#include "gpu/copy.h"
#include "gpu/curve.h"
#include "gpu/ffd/stage.h"
#include "gpu/shader_source.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trivar::gpu {

// What to draw, by value. Meshes are uploaded once and kept by Ref identity.
struct Instance {
    Ref<Mesh> mesh;
    glm::dmat4 to_world{1};
    Ref<std::vector<Material>> materials;
    int id = 0;               // what pick() returns; 0: not pickable
    PartKey part = {};        // tells it from others of this id; both tell what is still the same
    bool highlighted = false; // has an outline
    float opacity = 1;        // below 1: a ghost, for previews
    Ref<Mesh> rest = {};      // before it was deformed, vertex by vertex: for solid materials
    Ref<std::vector<float>> values = {}; // one a vertex: see value_colors
    // Drawn by one call: where the mesh stands, many times. Null: once, at to_world.
    Ref<std::vector<Copy>> copies = {};
    // Places in `copies` of those that have an outline while the instance is not highlighted.
    std::vector<std::uint32_t> outlined_copies = {};
    // What moves the vertices of `mesh` before that; its result is not looked at. Null: nothing.
    Ref<PosedMesh> posed = {};
    // Volumes that deform `mesh`, one after another, before to_world; `rest` is then not looked at.
    std::vector<Stage> stages = {};
};

// How the values of instances become colours; see gpu/color_map.h.
struct ValueColors {
    bool diverging = true;              // lightest in the middle, else from dark to light
    bool ratios = true;                 // shown by log2; 0 and less are hatched
    glm::vec2 range = glm::vec2(-1, 1); // of what is shown; beyond, as at its ends
};

// A line drawn over the scene to work on it, thin and dashed where something hides it.
struct Line {
    std::vector<glm::vec3> points; // world
    glm::vec4 color{1};            // linear
    float width_px = 2;
};

// A see-through surface over the scene: the faces of a volume, a strip, a tool. Unlit but for a rim
// where it has normals and turns away. Seen from behind it is fainter, and more so behind solid
// things. Their order does not matter.
struct Translucent {
    std::vector<glm::vec3> points;        // world
    std::vector<glm::vec4> colors;        // linear, with coverage; one a point, or one for all
    std::vector<std::uint32_t> triangles; // three points each, anticlockwise from the front
    std::vector<glm::vec3> normals = {};  // one a point, or none: flat, without a rim
};

// What is behind everything. Colours are display-linear; the share of a line is one of the encoded
// colour, so that a tenth looks like a tenth on any ground.
struct Backdrop {
    glm::vec3 top{0}, middle{0}, bottom{0};
    float corners = 0.55f; // how much darker they are
    float line_px = 1;     // width of the grid's finest lines
    glm::vec4 grid{0, 0, 0, 0.041f}, grid_major{0, 0, 0, 0.103f}, axis_x{0}, axis_y{0};
    bool operator==(const Backdrop&) const = default;
};

// Round highlighted instances; linear.
struct Outline {
    glm::vec4 color{1}, halo{0, 0, 0, 0.55f};
    float width_px = 2, halo_px = 1.5f;
    bool operator==(const Outline&) const = default;
};

// The edges of faces, where the settings ask for them. Linear.
struct EdgeStyle {
    glm::vec3 color{0.012f, 0.014f, 0.02f};
    bool alone = false; // of instances that are not drawn otherwise: as dark as of solid ones
    bool operator==(const EdgeStyle&) const = default;
};

struct Picture {
    Camera camera;
    RenderSettings settings;
    std::vector<Instance> instances;
    std::vector<Curve> curves;
    std::vector<Translucent> translucent;
    std::vector<Line> lines;
    Outline outline;
    EdgeStyle edges = {};
    // The values of instances are shown in place of materials, and what has none is grey.
    std::optional<ValueColors> value_colors;
    DeformBy deform_by = DeformBy::two_phases; // instances that have stages
    int samples = 4;                           // of antialiasing
    bool draft = false; // leave out the slow parts while something is being dragged
    bool deep = false;  // drawn with 16 bits a channel, and not dithered to 8
    double scale = 1;   // of the size: a draft drawn smaller is shown enlarged
    bool grid = false;  // lines on the ground, for orientation while working
    std::optional<Backdrop> backdrop = {}; // another than that of the look
    Ref<ShaderTexts> shaders = {};         // a developer's, in place of those embedded
};

} // namespace trivar::gpu
