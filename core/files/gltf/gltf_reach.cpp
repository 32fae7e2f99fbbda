// SPDX-License-Identifier: GPL-3.0-or-later
// This file checks that finite numbers do not move a mesh beyond the largest allowed coordinates.
#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_skins.h"
#include "core/mesh/pose.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace trivar {
namespace {

constexpr double beyond_all = std::numeric_limits<double>::infinity();

// Returns the largest coordinate of the corners of a box after a transform.
double furthest_corner(const Box& box, const glm::dmat4& matrix)
{
    double out = 0;
    for (const glm::dvec3& corner : box.corners()) {
        const glm::dvec3 there = glm::abs(glm::dvec3(matrix * glm::dvec4(corner, 1)));
        if (!finite(there)) return beyond_all;
        out = std::max({out, there.x, there.y, there.z});
    }
    return out;
}

// Reaches finds the largest coordinates of the meshes of a model in their places.
class Reaches {
public:
    explicit Reaches(const Model& model) : model_(model), stance_(stance_at(model, nullptr, 0)) {}

    double of(std::size_t index)
    {
        const int node = static_cast<int>(index);
        if (model_.nodes[index].morph_weights.empty()) stance_.morph_weights[index].clear();
        const std::optional<Box>& box = box_of(model_.nodes[index], node);
        if (!box) return beyond_all;
        return box->empty() ? 0 : furthest_corner(*box, mesh_to_model(model_, node, stance_));
    }

private:
    // Returns the box of the mesh of a node; none if some vertex is not finite. Nodes with the same
    // mesh, skin and weights share a box.
    const std::optional<Box>& box_of(const Node& node, int index)
    {
        const Key key{node.mesh, node.skin, node.morph_weights};
        const auto [known, fresh] = boxes_.try_emplace(key);
        if (!fresh) return known->second;
        const Ref<Mesh>& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        const Pose pose = pose_of(model_, index, stance_);
        const Mesh moved = pose.empty() ? Mesh() : posed(*mesh, pose);
        const Mesh& shown = pose.empty() ? *mesh : moved;
        if (std::ranges::all_of(shown.positions, [](const glm::vec3& p) { return finite(p); }))
            known->second = bounding_box(shown);
        return known->second;
    }

    using Key = std::tuple<int, int, std::vector<float>>; // mesh, skin, weights
    const Model& model_;
    Stance stance_;
    std::map<Key, std::optional<Box>> boxes_;
};

} // namespace

void check_gltf_reach(Model& model, const std::string& file_name, CountedNotices& notices)
{
    Reaches reaches(model);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        Node& node = model.nodes[n];
        const auto in_reach = [&] { return reaches.of(n) <= most_coordinate; };
        if (node.mesh < 0 || in_reach()) continue;
        if (std::exchange(node.skin, -1) >= 0) {
            notices.add("one skin moves its mesh further than 1e15 m and was left out",
                        "{0} skins move their meshes further than 1e15 m and were left out");
            if (in_reach()) continue;
        }
        if (!node.morph_weights.empty()) {
            node.morph_weights.clear();
            notices.add("the weights of the morph targets of one node move its mesh further than "
                        "1e15 m and were left out",
                        "the weights of the morph targets of {0} nodes move their meshes further "
                        "than 1e15 m and were left out");
            if (in_reach()) continue;
        }
        const double far = reaches.of(n);
        throw Rejected(fmt::format(
            "{}: {} reaches {} from the origin, but coordinates up to {} m are allowed; check "
            "its unit and its scale",
            file_name,
            node.name.empty() ? "a mesh" : fmt::format("the mesh of node '{}'", excerpt(node.name)),
            far < beyond_all ? number_text(far) + " m" : "infinitely far",
            number_text(most_coordinate)));
    }
}

} // namespace trivar
