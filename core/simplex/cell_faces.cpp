// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/cell_faces.h"

#include "core/simplex/cell_lattice.h"

#include <algorithm>

namespace trivar {

template <int S> std::vector<CellFace<S>> sorted_faces(const SimplexDomain<S>& domain)
{
    std::vector<CellFace<S>> faces;
    faces.reserve(domain.cells.size() * (S + 1));
    for (std::size_t c = 0; c < domain.cells.size(); ++c)
        for (std::size_t k = 0; k <= S; ++k) {
            CellFace<S> face{{}, static_cast<std::uint32_t>(c), static_cast<std::uint8_t>(k)};
            for (std::size_t i = 0, n = 0; i <= S; ++i)
                if (i != k) face.vertices[n++] = domain.cells[c][i];
            std::sort(face.vertices.begin(), face.vertices.end());
            faces.push_back(face);
        }
    std::sort(faces.begin(), faces.end(), [](const CellFace<S>& a, const CellFace<S>& b) {
        return a.vertices != b.vertices ? a.vertices < b.vertices : a.cell < b.cell;
    });
    return faces;
}

template std::vector<CellFace<2>> sorted_faces(const SimplexDomain<2>&);
template std::vector<CellFace<3>> sorted_faces(const SimplexDomain<3>&);

glm::dvec3 outward(const SimplexDomain<3>& domain, const CellFace<3>& face)
{
    std::array<glm::dvec3, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
        c[i] = domain.vertex(
            domain.cells[face.cell][static_cast<std::size_t>(outward_faces[face.opposite][i])]);
    return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
}

} // namespace trivar
