// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/pose.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace kernel {
using namespace glm;

// A PoseKernel evaluates the formulas of core/kernel in C++; the shaders include the same text.
struct PoseKernel {
    const Mesh& mesh;
    const Pose& pose;

    int morph_count() const { return static_cast<int>(pose.morph_weights.size()); }
    float morph_weight(int target) const
    {
        return pose.morph_weights[static_cast<std::size_t>(target)];
    }
    vec3 morph_difference(int target, int what, int vertex) const
    {
        const Mesh::MorphTarget& t = mesh.morph_targets[static_cast<std::size_t>(target)];
        const std::vector<vec3>& values = what == 0   ? t.positions
                                          : what == 1 ? t.normals
                                                      : t.tangents;
        return values.empty() ? vec3(0) : values[static_cast<std::size_t>(vertex)];
    }
    mat4 vertex_matrix(int vertex) const
    {
        if (pose.joints.empty()) return mat4(1);
        const Mesh::Influences& by = mesh.influences[static_cast<std::size_t>(vertex)];
        mat4 sum = pose.joints[by.joints[0]] * by.weights[0];
        for (std::size_t k = 1; k < by.joints.size(); ++k)
            if (const float weight = by.weights[static_cast<int>(k)]; weight != 0)
                sum += pose.joints[by.joints[k]] * weight;
        return sum;
    }

#include "core/kernel/normal.glsl"

#include "core/kernel/pose.glsl"
};

} // namespace kernel

namespace {

std::vector<float> weights_of(const Model& model, const Node& node)
{
    if (node.mesh < 0) return {};
    std::vector<float> weights = node.morph_weights;
    weights.resize(model.meshes[static_cast<std::size_t>(node.mesh)]->morph_targets.size(), 0);
    return weights;
}

} // namespace

Stance stance_at(const Model& model, const Clip* clip, double time_s)
{
    Stance out;
    out.to_model.resize(model.nodes.size());
    for (const Node& node : model.nodes) out.morph_weights.push_back(weights_of(model, node));
    std::vector<NodeTransform> placed(model.nodes.size());
    std::vector<bool> moved(model.nodes.size(), false);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) placed[i] = model.nodes[i].rest;
    for (std::size_t c = 0; clip && c < clip->channels.size(); ++c) {
        const Channel& channel = clip->channels[c];
        const auto node = static_cast<std::size_t>(channel.node);
        const std::vector<double> v = value_at(channel, time_s);
        if (channel.of == Channel::Of::morph_weights) {
            std::vector<float>& weights = out.morph_weights[node];
            for (std::size_t t = 0; t < std::min(weights.size(), v.size()); ++t)
                weights[t] = static_cast<float>(v[t]);
            continue;
        }
        moved[node] = true;
        if (channel.of == Channel::Of::translation) placed[node].translation = {v[0], v[1], v[2]};
        if (channel.of == Channel::Of::scale) placed[node].scale = {v[0], v[1], v[2]};
        if (channel.of == Channel::Of::rotation)
            placed[node].rotation = glm::dquat(v[3], v[0], v[1], v[2]);
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        const glm::dmat4 to_parent = moved[i] ? node.outer * placed[i].matrix() : node.to_parent;
        out.to_model[i] = node.parent < 0
                              ? to_parent
                              : out.to_model[static_cast<std::size_t>(node.parent)] * to_parent;
    }
    return out;
}

Pose pose_of(const Model& model, int index, const Stance& stance)
{
    const auto at = static_cast<std::size_t>(index);
    const Node& node = model.nodes[at];
    Pose out;
    const std::vector<float>& weights = stance.morph_weights[at];
    if (std::ranges::any_of(weights, [](float weight) { return weight != 0; }))
        out.morph_weights = weights;
    if (node.skin < 0) return out;
    const Skin& skin = model.skins[static_cast<std::size_t>(node.skin)];
    for (std::size_t k = 0; k < skin.joints.size(); ++k)
        out.joints.emplace_back(stance.to_model[static_cast<std::size_t>(skin.joints[k])] *
                                skin.mesh_to_joint[k]);
    return out;
}

glm::dmat4 mesh_to_model(const Model& model, int index, const Stance& stance)
{
    const auto at = static_cast<std::size_t>(index);
    return model.nodes[at].skin < 0 ? stance.to_model[at] : glm::dmat4(1);
}

Mesh posed(const Mesh& mesh, const Pose& pose)
{
    Mesh out = mesh;
    out.influences.clear();
    out.morph_targets.clear();
    constexpr std::size_t block = 4096;
    parallel_blocks(mesh.vertex_count(), block, [&](std::size_t begin, std::size_t end) {
        kernel::PoseKernel kernel{mesh, pose};
        for (std::size_t v = begin; v < end; ++v) {
            const glm::vec3 normal = mesh.normals.empty() ? glm::vec3(0, 0, 1) : mesh.normals[v];
            const glm::vec4 tangent =
                mesh.tangents.empty() ? glm::vec4(1, 0, 0, 1) : mesh.tangents[v];
            const auto there =
                kernel.posed_vertex(static_cast<int>(v), mesh.positions[v], normal, tangent);
            out.positions[v] = there.position;
            if (!out.normals.empty()) out.normals[v] = there.normal;
            if (!out.tangents.empty()) out.tangents[v] = there.tangent;
        }
    });
    return out;
}

glm::vec3 posed_point(const Mesh& mesh, const Pose& pose, std::uint32_t vertex)
{
    const int v = static_cast<int>(vertex);
    kernel::PoseKernel kernel{mesh, pose};
    return kernel.posed_vertex(v, mesh.positions[vertex], glm::vec3(0, 0, 1), glm::vec4(1, 0, 0, 1))
        .position;
}

Box bounding_box(const Model& model, const Clip* clip, double time_s)
{
    const Stance stance = stance_at(model, clip, time_s);
    Box out;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (const int curves = model.nodes[i].curves; curves >= 0)
            out.add(bounding_box(*model.curves[static_cast<std::size_t>(curves)]->points,
                                 stance.to_model[i]));
        if (model.nodes[i].mesh < 0) continue;
        const int node = static_cast<int>(i);
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(model.nodes[i].mesh)];
        const Pose pose = pose_of(model, node, stance);
        out.add(bounding_box(pose.empty() ? mesh : posed(mesh, pose),
                             mesh_to_model(model, node, stance)));
    }
    return out;
}

std::vector<Box> target_bounds(const Mesh& mesh)
{
    std::vector<Box> out;
    for (const Mesh::MorphTarget& target : mesh.morph_targets) {
        out.emplace_back().add(glm::dvec3(0));
        for (const glm::vec3& d : target.positions) out.back().add(glm::dvec3(d));
    }
    return out;
}

Box posed_bounds(const Box& mesh, const std::vector<Box>& targets, const Pose& pose)
{
    Box morphed = mesh;
    if (mesh.empty()) return mesh;
    for (std::size_t t = 0; t < pose.morph_weights.size(); ++t) {
        const glm::dvec3 a = targets[t].lo * double(pose.morph_weights[t]),
                         b = targets[t].hi * double(pose.morph_weights[t]);
        morphed.lo += glm::min(a, b);
        morphed.hi += glm::max(a, b);
    }
    if (pose.joints.empty()) return morphed;
    Box out; // a skinned point is a mean of points moved by joints, so it is in their box
    for (const glm::mat4& joint : pose.joints)
        for (const glm::dvec3& corner : morphed.corners())
            out.add(glm::dvec3(glm::dmat4(joint) * glm::dvec4(corner, 1)));
    return out;
}

Ref<PosedMesh> posed_later(const Ref<Mesh>& rest, Pose pose)
{
    const Lazy<Ref<Mesh>> mesh([=] { return make_ref(posed(*rest, pose)); });
    return make_ref(PosedMesh{rest, std::move(pose), mesh});
}

} // namespace trivar
