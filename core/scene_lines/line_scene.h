// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/lines/line_drawing.h"
#include "core/stages/evaluated.h"

namespace trivar {

// A LineScene is all that the lines of a scene depend on, as a camera sees it. Copies cost a
// pointer per object; equal ones have the same lines.
struct LineScene {
    struct Object {
        Ref<EvaluatedObject> effects;
        std::string name = {};                   // no two objects have one layer_id()
        std::optional<LineDrawing> drawing = {}; // of its meshes; none: they have no lines
        // Takes its model to the world, where levels of its volume data have lines; else none.
        std::optional<glm::dmat4> volume_to_world = {};
        bool has_lines() const { return drawing || volume_to_world; }
        bool operator==(const Object&) const = default;
    };
    std::vector<Object> objects; // by ascending id; none where nothing has lines
    Camera camera;
    bool operator==(const LineScene&) const = default;

    // Whether quick lines are all that it has: no line with a proof, nothing that may hide another
    // object's line, no lines of tiles, and no intersections. See LineEffort.
    bool is_simple() const;
};
// Returns whether volume data show the surface of a level other than the one with that surface; -1
// is a level without one.
bool shows_others(const ShownVolume& volume, int surface);

// The scene without those objects, ascending, that are hidden in the view alone.
LineScene line_scene(const Evaluation& evaluated, const Document& document, const Camera& camera,
                     std::span<const Id> hidden_here = {});

} // namespace trivar
