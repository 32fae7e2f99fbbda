// SPDX-License-Identifier: GPL-3.0-or-later
// Whether numbers that are finite each take a mesh to where nothing can be worked with.
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/gltf_nodes.h"
#include "core/files/gltf_skins.h"
#include "core/mesh/pose.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace trivar {
namespace {

// The largest coordinate of the mesh on a node as it stands, in the model; not a number where one
// is not.
double furthest_coordinate(const Model& model, int node, const Stance& stance)
{
    const Node& of = model.nodes[static_cast<std::size_t>(node)];
    const Ref<Mesh>& mesh = model.meshes[static_cast<std::size_t>(of.mesh)];
    const Pose pose = pose_of(model, node, stance);
    const glm::dmat4 matrix = mesh_to_model(model, node, stance);
    const Mesh moved = pose.empty() ? Mesh() : posed(*mesh, pose);
    double furthest = 0;
    for (const glm::vec3& p : pose.empty() ? mesh->positions : moved.positions) {
        const glm::dvec3 there(matrix * glm::dvec4(p, 1));
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(there[i]) <= furthest)) furthest = std::abs(there[i]);
    }
    return furthest;
}

} // namespace

void check_gltf_reach(Model& model, const std::string& file_name, CountedNotices& notices)
{
    const auto in_reach = [&](int node) {
        return furthest_coordinate(model, node, stance_at(model, nullptr, 0)) <=
               most_coordinate;
    };
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        Node& node = model.nodes[n];
        const int index = static_cast<int>(n);
        if (node.mesh < 0 || in_reach(index)) continue;
        if (std::exchange(node.skin, -1) >= 0) {
            notices.add("one skin takes its mesh further than 1e15 m and was left out",
                        "{0} skins take their meshes further than 1e15 m and were left out");
            if (in_reach(index)) continue;
        }
        if (!node.morph_weights.empty()) {
            node.morph_weights.clear();
            notices.add("the weights of the morph targets of one node take its mesh further than "
                        "1e15 m and were left out",
                        "the weights of the morph targets of {0} nodes take their meshes further "
                        "than 1e15 m and were left out");
            if (in_reach(index)) continue;
        }
        throw Rejected(fmt::format(
            "{}: {} reaches {:.3g} m from the origin, and places up to {:g} m can be worked with: "
            "is its unit or a scale wrong?",
            file_name,
            node.name.empty() ? "a mesh" : fmt::format("the mesh of node '{}'", excerpt(node.name)),
            furthest_coordinate(model, index, stance_at(model, nullptr, 0)), most_coordinate));
    }
}

} // namespace trivar
