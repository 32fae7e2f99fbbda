// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/border_fit.h"

#include "core/meshing/manifold_cells.h"
#include "core/simplex/simplex_domain.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int sweeps = 4;
constexpr std::array<double, 4> shares{1, 0.7, 0.4, 0.15}; // of the way, tried in turn

bool fits(const SimplexMesh<3>& mesh, const std::vector<int>& star, const std::vector<bool>& chosen,
          double least_angle)
{
    return std::all_of(star.begin(), star.end(), [&](int c) {
        std::array<glm::dvec3, 4> at;
        const auto& cell = mesh.cells[static_cast<std::size_t>(c)];
        for (std::size_t k = 0; k < 4; ++k)
            at[k] = mesh.vertices[static_cast<std::size_t>(cell[k])];
        return chosen[static_cast<std::size_t>(c)] ? least_dihedral(at) >= least_angle
                                                   : orientation(at) > 0;
    });
}

} // namespace

SimplexMesh<3> with_fitted_border(SimplexMesh<3> mesh, const std::vector<bool>& chosen,
                                  const std::vector<bool>& pinned, const BorderFit& fit)
{
    std::vector<std::size_t> border;
    for (const auto& face : border_faces(mesh, chosen))
        for (const int v : face)
            if (!pinned[static_cast<std::size_t>(v)]) border.push_back(static_cast<std::size_t>(v));
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    const std::vector<std::vector<int>> stars = vertex_stars(mesh);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const std::size_t v : border) {
            const glm::dvec3 from = mesh.vertices[v], foot = fit.surface.nearest(from);
            const double d = glm::distance(from, foot);
            if (!(d > 0)) continue;
            const glm::dvec3 way = (foot - from) * (1 - fit.distance[v] / d);
            const bool moved = std::any_of(shares.begin(), shares.end(), [&](double share) {
                mesh.vertices[v] = from + way * share;
                return fits(mesh, stars[v], chosen, fit.least_angle);
            });
            if (!moved) mesh.vertices[v] = from;
        }
    return mesh;
}

} // namespace trivar
