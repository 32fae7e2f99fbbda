// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/mesh/model.h"

namespace trivar {

// A Stance says how the nodes of a model stand.
struct Stance {
    std::vector<glm::dmat4> to_model;              // by node
    std::vector<std::vector<float>> morph_weights; // by node, as many as the mesh has targets
};

// The stance at a time of a clip; null: that of the file. O(#nodes + #channels log #keys).
Stance stance_at(const Model& model, const Clip* clip, double time_s);

// A Pose moves the vertices of a mesh one by one. Empty: nothing moves them.
struct Pose {
    // The transform of the mesh by each joint of the skin, to the place that it has in a node
    // without a transform.
    std::vector<glm::mat4> joints;
    std::vector<float> morph_weights; // by target; empty where all are 0
    bool empty() const { return joints.empty() && morph_weights.empty(); }
    bool operator==(const Pose&) const = default;
};

// The pose of the mesh that hangs on a node. A skinned mesh lies in model space and not where its
// node is.
Pose pose_of(const Model& model, int node, const Stance& stance);
glm::dmat4 mesh_to_model(const Model& model, int node, const Stance& stance);

// The mesh after morph targets and linear blend skinning, normals by cofactors
// (core/kernel/pose.glsl); it has neither influences nor targets. The pose must be of this mesh.
// O(#V by the number of targets with a weight). Any number of threads gives the same bits. Source:
// glTF 2.0, 3.7.2 and 3.7.3.
Mesh posed(const Mesh& mesh, const Pose& pose);
// the same bits as posed() gives
glm::vec3 posed_point(const Mesh& mesh, const Pose& pose, std::uint32_t vertex);

// The box of all meshes and curves of the model, in its space, at a time of the clip. O(#V).
Box bounding_box(const Model& model, const Clip* clip = nullptr, double time_s = 0);

// A box that holds the posed mesh, found without looking at all vertices of a skin; it may be
// larger than needed. O(8 #joints + #targets).
Box posed_bounds(const Box& mesh, const std::vector<Box>& targets, const Pose& pose);
std::vector<Box> target_bounds(const Mesh& mesh); // of the differences of positions, each with 0

// A PosedMesh is a mesh with its pose; the processor computes the result when it is asked for.
struct PosedMesh {
    Ref<Mesh> rest;
    Pose pose;
    Lazy<Ref<Mesh>> mesh;
};
Ref<PosedMesh> posed_later(const Ref<Mesh>& rest, Pose pose);

} // namespace trivar
