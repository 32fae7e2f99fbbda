// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/bcc_cells.h"

#include "core/simplex/simplex_domain.h"

#include <cmath>

namespace trivar {
namespace {

// Half a cube at each end is ragged.
glm::dvec3 cubes_along(const Box& box, double edge)
{
    return glm::ceil(box.size() / edge) + 1.0;
}

} // namespace

double bcc_cell_count(const Box& box, double edge)
{
    const glm::dvec3 n = cubes_along(box, edge);
    return 12 * n.x * n.y * n.z;
}

SimplexMesh<3> bcc_cells(const Box& box, double edge)
{
    const glm::ivec3 n(cubes_along(box, edge));
    const glm::dvec3 lo = box.center() - glm::dvec3(n) * (edge / 2);
    SimplexMesh<3> out;
    const auto put = [&](const glm::ivec3& count, double shift) {
        for (int i = 0; i < count.x; ++i)
            for (int j = 0; j < count.y; ++j)
                for (int k = 0; k < count.z; ++k)
                    out.vertices.push_back(lo + (glm::dvec3(i, j, k) + shift) * edge);
    };
    put(n + 1, 0);
    const int corners = static_cast<int>(out.vertices.size());
    put(n, 0.5);
    const auto corner = [&](const glm::ivec3& p) {
        return (p.x * (n.y + 1) + p.y) * (n.z + 1) + p.z;
    };
    const auto center = [&](const glm::ivec3& p) {
        return corners + (p.x * n.y + p.y) * n.z + p.z;
    };
    // four cells round each edge from the centre of a cube to that of the next
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 along(0), u(0), v(0);
        along[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
        for (int i = along.x; i < n.x; ++i)
            for (int j = along.y; j < n.y; ++j)
                for (int k = along.z; k < n.z; ++k) {
                    const glm::ivec3 p(i, j, k);
                    const std::array<glm::ivec3, 4> face{p, p + u, p + u + v, p + v};
                    for (std::size_t q = 0; q < 4; ++q)
                        out.cells.push_back({center(p - along), corner(face[q]),
                                             corner(face[(q + 1) % 4]), center(p)});
                }
    }
    return out;
}

} // namespace trivar
