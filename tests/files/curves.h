// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar::testing {

using Line = std::vector<glm::vec3>;

// The lines of a model where its nodes stand.
inline std::vector<Line> lines_of(const Model& model)
{
    std::vector<Line> out;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].curves < 0) continue;
        const Curves curves =
            transformed(*model.curves[static_cast<std::size_t>(model.nodes[n].curves)],
                        node_to_model(model, static_cast<int>(n)));
        const std::vector<glm::vec3>& p = curves.points->positions;
        for (std::size_t l = 0; l < curves.line_count(); ++l)
            out.emplace_back(p.begin() + curves.begin[l], p.begin() + curves.begin[l + 1]);
    }
    return out;
}

// A square, closed, of one material, and a zigzag and two short lines of another.
inline Model curves_model()
{
    Mesh points;
    points.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1},
                        {1, 0, 2}, {2, 0, 1}, {3, 0, 0}, {3, 0, 1}, {4, 0, 0}, {4, 0, 1}};
    Model model;
    model.curves = {make_ref(Curves{make_ref(std::move(points)), {0, 5, 8, 10, 12}, {0, 1, 1, 1}})};
    model.nodes = {Node{.name = "wires", .curves = 0}};
    model.materials.resize(2);
    model.materials[0].name = "red";
    model.materials[0].base_color = {0.8f, 0.1f, 0.1f, 1};
    model.materials[1].name = "blue";
    model.materials[1].base_color = {0.1f, 0.1f, 0.8f, 1};
    return model;
}

} // namespace trivar::testing
