// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/places_in_file.h"

namespace trivar {

const Channel* weights_of_node(const Model& model, int node)
{
    if (model.clips.empty()) return nullptr;
    for (const Channel& channel : model.clips.front().channels)
        if (channel.node == node && channel.of == Channel::Of::morph_weights) return &channel;
    return nullptr;
}

std::vector<glm::dvec3> places_in_file(const Model& model, int node, const Stance& stance,
                                       const Channel* weights, double time_s)
{
    const Node& at = model.nodes[static_cast<std::size_t>(node)];
    const Mesh& mesh = *model.meshes[static_cast<std::size_t>(at.mesh)];
    std::vector<glm::dvec3> out(mesh.positions.begin(), mesh.positions.end());
    if (weights && !mesh.morph_targets.empty()) {
        const std::vector<double> w = value_at(*weights, time_s);
        for (std::size_t t = 0; t < w.size(); ++t)
            if (w[t] != 0)
                for (std::size_t v = 0; v < out.size(); ++v)
                    out[v] += w[t] * glm::dvec3(mesh.morph_targets[t].positions[v]);
    }
    if (at.skin < 0) {
        const glm::dmat4& to_world = stance.to_model[static_cast<std::size_t>(node)];
        for (glm::dvec3& p : out) p = glm::dvec3(to_world * glm::dvec4(p, 1));
        return out;
    }
    const Skin& skin = model.skins[static_cast<std::size_t>(at.skin)];
    std::vector<glm::dmat4> joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
        joints.push_back(stance.to_model[static_cast<std::size_t>(skin.joints[j])] *
                         skin.mesh_to_joint[j]);
    for (std::size_t v = 0; v < out.size(); ++v) {
        const Mesh::Influences& by = mesh.influences[v];
        glm::dvec4 sum(0);
        for (int k = 0; k < 4; ++k)
            if (by.weights[k] > 0)
                sum += double{by.weights[k]} *
                       (joints[by.joints[static_cast<std::size_t>(k)]] * glm::dvec4(out[v], 1));
        out[v] = glm::dvec3(sum);
    }
    return out;
}

std::vector<glm::dvec3> places_in_scene(const Part& part)
{
    const Mesh mesh = part.posed ? posed(*part.rest, part.posed->pose) : *part.rest;
    std::vector<glm::dvec3> out;
    out.reserve(mesh.vertex_count());
    for (const glm::vec3& p : mesh.positions) out.emplace_back(part.to_world * glm::dvec4(p, 1));
    return out;
}

} // namespace trivar
