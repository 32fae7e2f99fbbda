// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"
#include "core/simplex/simplex_mesh.h"

#include <map>

namespace trivar {

// Cells of the triangulation of a complex of CGAL's mesher; vertices by their first use.
struct MesherCells {
    SimplexMesh<3> mesh;
    std::vector<int> dimension; // by vertex: of what it is in, 3 within a body, 2 in a surface
};
template <class Complex>
MesherCells mesher_cells(const Complex& complex,
                         const std::vector<typename Complex::Cell_handle>& cells)
{
    MesherCells all;
    SimplexMesh<3>& out = all.mesh;
    std::map<typename Complex::Vertex_handle, int> numbers; // not a result's order
    for (const auto c : cells) {
        std::array<int, 4> cell;
        std::array<glm::dvec3, 4> at;
        for (int k = 0; k < 4; ++k) {
            const auto v = c->vertex(k);
            const auto [found, added] =
                numbers.try_emplace(v, static_cast<int>(out.vertices.size()));
            if (added) {
                const auto& p = v->point();
                out.vertices.emplace_back(p.x(), p.y(), p.z());
                all.dimension.push_back(complex.in_dimension(v));
            }
            cell[static_cast<std::size_t>(k)] = found->second;
            at[static_cast<std::size_t>(k)] = out.vertices[static_cast<std::size_t>(found->second)];
        }
        if (orientation(at) < 0) std::swap(cell[2], cell[3]);
        out.cells.push_back(cell);
    }
    return all;
}

// Takes all cells of the complex, in its order.
template <class Complex> MesherCells mesher_cells(const Complex& complex)
{
    std::vector<typename Complex::Cell_handle> cells;
    for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c)
        cells.push_back(c);
    return mesher_cells(complex, cells);
}

} // namespace trivar
