// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/model.h"

#include "core/base/mistake.h"

namespace trivar {

glm::dmat4 node_to_model(const Model& model, int node)
{
    glm::dmat4 result(1);
    while (node >= 0) {
        const Node& n = model.nodes.at(static_cast<std::size_t>(node));
        ensure(n.parent < node, "a node comes before its parent");
        result = n.to_parent * result;
        node = n.parent;
    }
    return result;
}

std::size_t line_count(const Model& model)
{
    std::size_t out = 0;
    for (const Node& node : model.nodes)
        if (node.curves >= 0)
            out += model.curves.at(static_cast<std::size_t>(node.curves))->line_count();
    return out;
}

Model single_mesh_model(std::string name, Mesh mesh, std::vector<Material> materials)
{
    Model model;
    model.meshes = {make_ref(std::move(mesh))};
    model.nodes = {Node{std::move(name), -1, glm::dmat4(1), 0}};
    model.materials = std::move(materials);
    if (model.materials.empty()) model.materials.emplace_back();
    return model;
}

} // namespace trivar
