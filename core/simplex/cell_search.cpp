// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/cell_search.h"

#include "core/simplex/simplex_domain.h"

#include <algorithm>

namespace trivar {
namespace {

std::array<glm::dvec3, 4> corners_of(const SimplexMesh<3>& mesh, std::size_t cell)
{
    std::array<glm::dvec3, 4> out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = mesh.vertices[static_cast<std::size_t>(mesh.cells[cell][k])];
    return out;
}

} // namespace

CellSearch::CellSearch(SimplexMesh<3> mesh) : mesh_(std::move(mesh))
{
    std::vector<CellBox<3>> boxes;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        const auto at = corners_of(mesh_, c);
        CellBox<3> box{at[0], at[0]};
        for (const glm::dvec3& p : at) box.lo = glm::min(box.lo, p), box.hi = glm::max(box.hi, p);
        boxes.push_back(box);
    }
    grid_ = BoxGrid<3>(boxes);
}

int CellSearch::cell_at(const glm::dvec3& x) const
{
    for (const std::int32_t c : grid_.boxes_at(x)) {
        const auto at = corners_of(mesh_, static_cast<std::size_t>(c));
        const double whole = orientation(at);
        bool inside = true;
        for (std::size_t k = 0; inside && k < 4; ++k) {
            auto with = at;
            with[k] = x;
            inside = orientation(with) >= -1e-12 * whole;
        }
        if (inside) return c;
    }
    return -1;
}

} // namespace trivar
