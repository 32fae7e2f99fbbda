// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_skins.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

struct ReadSkin {
    Skin skin;
    bool whole = true; // every joint has a matrix and is in the model
};

ReadSkin read_skin(const GltfEntry& from, GltfAccessors& accessors, const std::vector<int>& node_of,
                   CountedNotices& notices)
{
    constexpr std::size_t max_joints = 65536; // influences hold 16 bits each
    ReadSkin out;
    const std::vector<int> joints = from.indices("joints");
    if (joints.size() > max_joints)
        from.fail(
            fmt::format("it has {} joints, but may have at most {}", joints.size(), max_joints));
    constexpr std::size_t joint_bytes = 200; // with its matrix, in the file and in a pose
    accessors.file().account(from, joints.size(), "joints", joint_bytes);
    for (const int joint : joints) {
        const bool there = joint >= 0 && static_cast<std::size_t>(joint) < node_of.size() &&
                           node_of[static_cast<std::size_t>(joint)] >= 0;
        out.whole &= there;
        out.skin.joints.push_back(there ? node_of[static_cast<std::size_t>(joint)] : 0);
    }
    out.whole &= !joints.empty();
    out.skin.mesh_to_joint.assign(joints.size(), glm::dmat4(1));
    if (from.index("inverseBindMatrices") < 0) return out;
    const GltfAccessors::Table table = accessors.floats(from, "inverseBindMatrices");
    if (table.components != 16 || table.count < joints.size())
        from.fail(fmt::format("'inverseBindMatrices' must be a matrix of 4 x 4 for each of its {} "
                              "joints",
                              joints.size()));
    if (table.not_finite > 0) {
        out.whole = false;
        notices.add("one skin has matrices with values that are not finite numbers",
                    "{0} skins have matrices with values that are not finite numbers");
    }
    for (std::size_t k = 0; k < joints.size(); ++k)
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) // the last row is 0 0 0 1
                out.skin.mesh_to_joint[k][c][r] =
                    double(table.values[16 * k + static_cast<std::size_t>(4 * c + r)]);
    return out;
}

std::size_t last_joint(const Mesh& mesh)
{
    std::uint16_t out = 0;
    for (const Mesh::Influences& by : mesh.influences)
        out = std::max(out, *std::ranges::max_element(by.joints));
    return out;
}

} // namespace

void add_gltf_skins(Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
                    CountedNotices& notices)
{
    const GltfFile& file = accessors.file();
    std::vector<bool> whole;
    std::map<int, std::size_t> last_joints; // by mesh, which many nodes may show
    file.root().each("skins", "skin", [&](const GltfEntry& each) {
        ReadSkin read = read_skin(each, accessors, node_of, notices);
        model.skins.push_back(std::move(read.skin));
        whole.push_back(read.whole);
    });
    file.root().each("nodes", "node", [&, i = std::size_t{0}](const GltfEntry& from) mutable {
        const int at = node_of[i++];
        if (at < 0 || from.index("skin") < 0) return;
        Node& node = model.nodes[static_cast<std::size_t>(at)];
        file.named(from, "skin", "skins", "skin");
        if (node.mesh < 0) return;
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(node.mesh)];
        const auto number = static_cast<std::size_t>(from.index("skin"));
        if (mesh.influences.empty() || !whole[number])
            return notices.add("one skin lacks joints or weights and was left out",
                               "{0} skins lack joints or weights and were left out");
        const auto [last, fresh] = last_joints.try_emplace(node.mesh);
        if (fresh) last->second = last_joint(mesh);
        if (const std::size_t count = model.skins[number].joints.size(); last->second >= count)
            from.fail(fmt::format("a vertex of its mesh is bound to joint {}, but its skin has {} "
                                  "joints, counted from 0",
                                  last->second, count));
        node.skin = from.index("skin");
    });
}

} // namespace trivar
