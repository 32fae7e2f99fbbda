// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/extent.h"

#include <string>
#include <vector>

namespace trivar {

// What a source gives, subdivided, ready to be drawn or laid.
struct Shape {
    struct NodeMesh {
        Ref<Mesh> rest;
        glm::dmat4 to_model{1};
        Ref<PosedMesh> posed = nullptr; // where a skin or morph targets move the vertices
        int node = 0;                   // of the model
        int slot = 0;                   // which of its shape's it is, whichever stand in a pose
        Ref<Extent> extent = nullptr;
        Box bounds = {}; // before to_model, as it stands, or larger ones
        const Ref<Mesh>& mesh() const { return posed ? *posed->mesh : rest; }
    };
    struct NodeCurves {
        Ref<Curves> curves;
        glm::dmat4 to_model{1};
        int node = 0;    // of the model
        int slot = 0;    // which of its shape's they are
        Box bounds = {}; // before to_model
    };
    std::vector<NodeMesh> meshes;   // those that hang on a node
    std::vector<NodeCurves> curves; // the same; no pose moves them but that of their node
    Ref<Model> model;               // never null
    Ref<std::vector<Material>> materials;
    std::vector<std::string> notices;
    // Why something of it is missing, of those notices: a file that cannot be read, numbers that
    // are too large.
    std::vector<std::string> lacks;

    bool empty() const { return meshes.empty() && curves.empty(); }
};

// A shape of all meshes and curves that hang on nodes of the model, as the model came.
Shape shape_of(Ref<Model> model);
// Splits its faces by Catmull and Clark. Meshes that hang on several nodes are subdivided once, and
// skins and morph targets move nothing any more.
void subdivide(Shape& shape, int levels, const Progress& progress);
// Adds a sentence about something that is missing.
void say_lacking(Shape& shape, const std::string& why);

// Puts its meshes where the nodes of its model stand; those that would be out of reach go.
void stand(Shape& shape, const Stance& stance);
// The same where a clip of its model has them at that time, or as the model came.
void stand(Shape& shape, const Clip* clip, double time_s);

} // namespace trivar
