// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/low_vertices.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <limits>
#include <map>

namespace trivar {
namespace {

const Mesh& mesh_on(const Model& model, int node)
{
    return *model
                .meshes[static_cast<std::size_t>(model.nodes[static_cast<std::size_t>(node)].mesh)];
}

// Finds the lowest height of every vertex of the mesh on a node.
std::vector<double> lowest_heights(const Model& model, int node, const std::vector<Stance>& all,
                                   const glm::dvec3& up)
{
    const Mesh& mesh = mesh_on(model, node);
    constexpr std::size_t block = 8;
    std::vector<std::vector<double>> of_block((all.size() + block - 1) / block);
    parallel_blocks(all.size(), block, [&](std::size_t begin, std::size_t end) {
        std::vector<double>& lowest = of_block[begin / block];
        lowest.assign(mesh.vertex_count(), std::numeric_limits<double>::infinity());
        for (std::size_t i = begin; i < end; ++i) {
            const Pose pose = pose_of(model, node, all[i]);
            const glm::dmat4 to_model = mesh_to_model(model, node, all[i]);
            for (std::size_t v = 0; v < lowest.size(); ++v) {
                const glm::dvec3 p = posed_point(mesh, pose, static_cast<std::uint32_t>(v));
                lowest[v] =
                    std::min(lowest[v], glm::dot(up, glm::dvec3(to_model * glm::dvec4(p, 1))));
            }
        }
    });
    std::vector<double> out = std::move(of_block.front());
    for (const std::vector<double>& other : of_block)
        if (!other.empty())
            for (std::size_t v = 0; v < out.size(); ++v) out[v] = std::min(out[v], other[v]);
    return out;
}

} // namespace

glm::dvec3 position_of(const Model& model, const ModelVertex& vertex, const Stance& stance,
                       const Pose& pose)
{
    return glm::dvec3(mesh_to_model(model, vertex.node, stance) *
                      glm::dvec4(posed_point(mesh_on(model, vertex.node), pose, vertex.vertex), 1));
}

std::vector<glm::dvec3> positions_of(const Model& model, const std::vector<ModelVertex>& vertices,
                                     const Stance& stance)
{
    std::vector<glm::dvec3> out;
    std::map<int, Pose> known;
    for (const ModelVertex& each : vertices) {
        if (!known.contains(each.node)) known[each.node] = pose_of(model, each.node, stance);
        out.push_back(position_of(model, each, stance, known[each.node]));
    }
    return out;
}

std::vector<VertexMover> movers_of(const Model& model, const ModelVertex& vertex)
{
    const Node& node = model.nodes[static_cast<std::size_t>(vertex.node)];
    const Mesh& mesh = mesh_on(model, vertex.node);
    if (node.skin < 0 || mesh.influences.empty()) return {{vertex.node}};
    const Skin& skin = model.skins[static_cast<std::size_t>(node.skin)];
    const Mesh::Influences& by = mesh.influences[vertex.vertex];
    std::vector<VertexMover> out;
    for (int k = 0; k < 4; ++k) {
        const auto joint = by.joints[static_cast<std::size_t>(k)];
        if (by.weights[k] > 0)
            out.push_back({skin.joints[joint], skin.mesh_to_joint[joint], by.weights[k]});
    }
    return out;
}

int mover_of(const Model& model, const ModelVertex& vertex)
{
    const Node& node = model.nodes[static_cast<std::size_t>(vertex.node)];
    const Mesh& mesh = mesh_on(model, vertex.node);
    if (node.skin < 0 || mesh.influences.empty()) return vertex.node;
    const Mesh::Influences& by = mesh.influences[vertex.vertex];
    int most = 0;
    for (int k = 1; k < 4; ++k)
        if (by.weights[k] > by.weights[most]) most = k;
    return model.skins[static_cast<std::size_t>(node.skin)]
        .joints[by.joints[static_cast<std::size_t>(most)]];
}

LowVertices low_vertices(const Model& model, const std::vector<Stance>& stances,
                         const glm::dvec3& up, double within, double floor, std::size_t most)
{
    LowVertices out;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::pair<int, std::vector<double>>> nodes;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0) continue;
        const int node = static_cast<int>(n);
        nodes.emplace_back(node, lowest_heights(model, node, stances, up));
        for (const double each : nodes.back().second) least = std::min(least, each);
    }
    out.ground = std::max(least, floor);
    std::vector<std::pair<double, ModelVertex>> low;
    for (const auto& [node, lowest] : nodes)
        for (std::size_t v = 0; v < lowest.size(); ++v)
            if (lowest[v] < out.ground + within)
                low.push_back({lowest[v], {node, static_cast<std::uint32_t>(v)}});
    std::ranges::stable_sort(low, {}, [](const auto& each) { return each.first; });
    const std::size_t step = low.size() / most + 1;
    for (std::size_t i = 0; i < low.size(); i += step) out.vertices.push_back(low[i].second);
    return out;
}

} // namespace trivar
