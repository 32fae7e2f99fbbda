// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_mesh.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/simplex/cell_faces.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

double least_dihedral(const std::array<glm::dvec3, 4>& c)
{
    if (!(orientation(c) > 0)) return 0;
    const std::array<std::array<std::size_t, 3>, 4> faces{
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}}; // opposite to each corner
    std::array<glm::dvec3, 4> normals;
    for (std::size_t f = 0; f < 4; ++f)
        normals[f] = glm::normalize(
            glm::cross(c[faces[f][1]] - c[faces[f][0]], c[faces[f][2]] - c[faces[f][0]]));
    double cosine = -1;
    for (std::size_t f = 0; f < 4; ++f)
        for (std::size_t g = 0; g < f; ++g)
            cosine = std::max(cosine, -glm::dot(normals[f], normals[g]));
    return std::acos(std::min(cosine, 1.0));
}

double least_dihedral(const SimplexMesh<3>& mesh)
{
    double out = std::acos(-1.0);
    for (const auto& cell : mesh.cells) {
        std::array<glm::dvec3, 4> c;
        for (std::size_t k = 0; k < 4; ++k) c[k] = mesh.vertices[static_cast<std::size_t>(cell[k])];
        out = std::min(out, least_dihedral(c));
    }
    return out;
}

SimplexMesh<3> part_of(const SimplexMesh<3>& mesh, const std::vector<int>& cells)
{
    std::vector<int> number(mesh.vertices.size(), -1);
    for (const int c : cells)
        for (const int v : mesh.cells[static_cast<std::size_t>(c)])
            number[static_cast<std::size_t>(v)] = 0;
    SimplexMesh<3> out;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
    }
    out.cells.reserve(cells.size());
    for (const int c : cells) {
        std::array<int, 4> cell = mesh.cells[static_cast<std::size_t>(c)];
        for (int& v : cell) v = number[static_cast<std::size_t>(v)];
        out.cells.push_back(cell);
    }
    return out;
}

std::vector<std::vector<int>> vertex_stars(const SimplexMesh<3>& mesh)
{
    std::vector<std::vector<int>> out(mesh.vertices.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (const int v : mesh.cells[c])
            out[static_cast<std::size_t>(v)].push_back(static_cast<int>(c));
    return out;
}

void check(const SimplexMesh<3>& mesh)
{
    for (const glm::dvec3& v : mesh.vertices)
        if (!finite(v)) throw Rejected("A vertex of the cells is not a number.");
    const int count = static_cast<int>(mesh.vertices.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        std::array<glm::dvec3, 4> at;
        for (std::size_t k = 0; k < 4; ++k) {
            const int v = mesh.cells[c][k];
            if (v < 0 || v >= count)
                throw Rejected(fmt::format("Cell {} names vertex {} of {}.", c, v, count));
            at[k] = mesh.vertices[static_cast<std::size_t>(v)];
        }
        if (!(orientation(at) > 0)) throw Rejected(fmt::format("Cell {} is flat or inverted.", c));
    }
    SimplexDomain<3> domain;
    domain.cells = mesh.cells;
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f + 2 < faces.size(); ++f)
        if (faces[f].vertices == faces[f + 2].vertices)
            throw Rejected("Three cells share one face.");
}

} // namespace trivar
