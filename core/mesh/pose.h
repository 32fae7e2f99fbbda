// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/mesh/model.h"

namespace trivar {

// How the nodes of a model stand.
struct Stance {
    std::vector<glm::dmat4> to_model;              // by node
    std::vector<std::vector<float>> morph_weights; // by node, as many as the mesh has targets
};

// At a time of a clip; null: as the model came. O(#nodes + #channels log #keys).
Stance stance_at(const Model& model, const Clip* clip, double time_s);

// What moves the vertices of a mesh one by one. Empty: nothing.
struct Pose {
    // By joint of the skin, from the mesh to where a node without a place of its own would put it.
    std::vector<glm::mat4> joints;
    std::vector<float> morph_weights; // by target; none where all are 0
    bool empty() const { return joints.empty() && morph_weights.empty(); }
    bool operator==(const Pose&) const = default;
};

// Of the mesh that hangs on a node. A skinned mesh lies in model space and not where its node is.
Pose pose_of(const Model& model, int node, const Stance& stance);
glm::dmat4 mesh_to_model(const Model& model, int node, const Stance& stance);

// Linear blend skinning after morph targets, normals by cofactors (core/kernel/pose.glsl); the
// result has neither influences nor targets. The pose must be of this mesh. O(#V by targets that
// have a weight). The same bits for any number of threads. Source: glTF 2.0, 3.7.2 and 3.7.3.
Mesh posed(const Mesh& mesh, const Pose& pose);
glm::vec3 posed_point(const Mesh& mesh, const Pose& pose, std::uint32_t vertex); // the same bits

// The box of all meshes and curves of the model, in its space, as they stand. O(#V).
Box bounding_box(const Model& model, const Clip* clip = nullptr, double time_s = 0);

// The box of the posed mesh, or a larger one, without looking at all vertices of a skin.
// O(8 #joints + #targets).
Box posed_bounds(const Box& mesh, const std::vector<Box>& targets, const Pose& pose);
std::vector<Box> target_bounds(const Mesh& mesh); // of the differences of positions, each with 0

// A mesh with what moves it, worked out by the processor when it is asked for.
struct PosedMesh {
    Ref<Mesh> rest;
    Pose pose;
    Lazy<Ref<Mesh>> mesh;
};
Ref<PosedMesh> posed_later(const Ref<Mesh>& rest, Pose pose);

} // namespace trivar
