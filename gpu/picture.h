// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/document/render_settings.h"
#include "core/mesh/model.h"

#include <vector>

namespace trivar::gpu {

// What to draw, by value. Meshes are uploaded once and kept by Ref identity.
struct Instance {
    Ref<Mesh> mesh;
    glm::dmat4 to_world{1};
    Ref<std::vector<Material>> materials;
    int id = 0;               // what pick() returns; 0: not pickable
    bool highlighted = false; // an outline in the accent colour
    float opacity = 1;        // below 1: a ghost, for previews
};

// A line drawn over the scene, dimmed where something hides it.
struct Line {
    std::vector<glm::vec3> points; // world
    glm::vec4 color{1};            // linear
    float width_px = 2;
};

struct Picture {
    Camera camera;
    RenderSettings settings;
    std::vector<Instance> instances;
    std::vector<Line> lines;
    int samples = 4;    // of antialiasing
    bool draft = false; // leave out the slow parts while something is being dragged
    double scale = 1;   // of the size: a draft drawn smaller is shown enlarged
    bool grid = false;  // lines on the ground, for orientation while working
};

} // namespace trivar::gpu
