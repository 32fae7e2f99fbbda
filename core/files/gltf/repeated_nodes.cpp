// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/repeated_nodes.h"

#include "core/base/mistake.h"
#include "core/mesh/node_parts.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace trivar {
namespace {

// Says which nodes matter for more than the mesh that they show where they stand.
std::vector<bool> nodes_that_matter(const Model& model)
{
    std::vector<bool> out(model.nodes.size(), false);
    const auto mark = [&](int node) { out[static_cast<std::size_t>(node)] = true; };
    for (const Node& node : model.nodes)
        if (node.parent >= 0) mark(node.parent);
    for (const Skin& skin : model.skins)
        for (const int joint : skin.joints) mark(joint);
    for (const Clip& clip : model.clips)
        for (const Channel& channel : clip.channels) mark(channel.node);
    return out;
}

bool shows_anything(const Model& model, const Node& node)
{
    return node.mesh < 0 || node.curves >= 0 ||
           model.meshes[static_cast<std::size_t>(node.mesh)]->vertex_count() > 0;
}

bool shows_a_rigid_mesh(const Model& model, const Node& node)
{
    if (node.mesh < 0 || node.curves >= 0 || node.skin >= 0 || !node.morph_weights.empty())
        return false;
    if (model.meshes[static_cast<std::size_t>(node.mesh)]->face_count() == 0) return false;
    const std::optional<NodeTransform> parts = as_parts(node.to_parent);
    return parts && parts->scale.x > 0; // below 0, its faces are turned round
}

} // namespace

std::vector<std::vector<int>> repeated_nodes(const Model& model)
{
    const std::vector<bool> matters = nodes_that_matter(model);
    std::map<std::tuple<int, std::string, const Mesh*>, std::size_t> group_of; // looked up only
    std::vector<std::vector<int>> groups;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        if (matters[n] || !shows_a_rigid_mesh(model, node)) continue;
        const Mesh* mesh = model.meshes[static_cast<std::size_t>(node.mesh)].get();
        const auto [at, fresh] =
            group_of.try_emplace({node.parent, node.name, mesh}, groups.size());
        if (fresh) groups.emplace_back();
        groups[at->second].push_back(static_cast<int>(n));
    }
    std::erase_if(groups, [](const std::vector<int>& group) { return group.size() < 2; });
    return groups;
}

Model with_repeated_last(Model model)
{
    ensure(model.skins.empty() && model.clips.empty(), "a model that moves is not rearranged");
    const std::vector<std::vector<int>> groups = repeated_nodes(model);
    const std::vector<bool> matters = nodes_that_matter(model);
    std::vector<bool> later(model.nodes.size(), false);
    for (const std::vector<int>& group : groups)
        for (const int n : group) later[static_cast<std::size_t>(n)] = true;
    std::vector<int> number(model.nodes.size(), -1);
    std::vector<Node> nodes;
    nodes.reserve(model.nodes.size());
    const auto take = [&](std::size_t n) {
        number[n] = static_cast<int>(nodes.size());
        nodes.push_back(std::move(model.nodes[n]));
        int& parent = nodes.back().parent;
        if (parent >= 0) parent = number[static_cast<std::size_t>(parent)];
    };
    for (std::size_t n = 0; n < later.size(); ++n)
        if (!later[n] && (matters[n] || shows_anything(model, model.nodes[n]))) take(n);
    for (const std::vector<int>& group : groups)
        for (const int n : group) take(static_cast<std::size_t>(n));
    model.nodes = std::move(nodes);
    return model;
}

} // namespace trivar
