// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/extent.h"

#include <string>
#include <vector>

namespace trivar {

struct ShownVolume;

// A Shape is the result of a source, subdivided and ready to be drawn or laid.
struct Shape {
    struct NodeMesh {
        Ref<Mesh> rest;
        glm::dmat4 to_model{1};
        Ref<PosedMesh> posed = nullptr; // not null where a skin or morph targets move the vertices
        int node = 0;                   // of the model
        int slot = 0;                   // number of the mesh in its shape, the same in every pose
        // The cage that was subdivided to make it, in its pose; null: it was not subdivided.
        Ref<Mesh> cage = nullptr;
        Ref<Extent> extent = nullptr;
        Box bounds = {}; // before to_model, in the present pose; may be larger than needed
        const Ref<Mesh>& mesh() const { return posed ? *posed->mesh : rest; }
    };
    struct NodeCurves {
        Ref<Curves> curves;
        glm::dmat4 to_model{1};
        int node = 0;    // of the model
        int slot = 0;    // number of the curves in their shape
        Box bounds = {}; // before to_model
    };
    std::vector<NodeMesh> meshes; // of the meshes that hang on a node
    // The curves that hang on a node; a pose moves only their node.
    std::vector<NodeCurves> curves;
    Ref<Model> model; // never null
    Ref<std::vector<Material>> materials;
    std::vector<std::string> notices;
    Ref<ShownVolume> volume = nullptr; // of volume data; null: it is none
    // The notices that say why something of the shape is missing: a file that cannot be read,
    // numbers that are too large.
    std::vector<std::string> lacks;

    bool empty() const { return meshes.empty() && curves.empty(); }
};

// The shape holds all meshes and curves that hang on nodes of the model, in the model's own pose.
Shape shape_of(Ref<Model> model);
// Subdivides the faces by Catmull and Clark. A mesh that hangs on several nodes is subdivided once.
// Skins and morph targets then move nothing any more.
void subdivide(Shape& shape, int levels, const Progress& progress);
// Adds a sentence on something missing.
void say_lacking(Shape& shape, const std::string& why);

// Puts the meshes where the nodes of their model stand; meshes that would be out of range are
// removed.
void stand(Shape& shape, const Stance& stance);
// Puts the meshes where the clip has them at a time; null: where the model has them.
void stand(Shape& shape, const Clip* clip, double time_s);

} // namespace trivar
