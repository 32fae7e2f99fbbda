// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/simplex_sheet.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"
#include "core/mesh/grid_mesh.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_basis.h"

namespace trivar {
namespace {

std::vector<glm::dvec3> displacements(const SimplexBasis<2>& basis,
                                      const std::vector<SheetLift>& lifts)
{
    std::vector<glm::dvec3> out(basis.point_count(), glm::dvec3(0));
    for (const SheetLift& lift : lifts)
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] +=
                lift.by * decay(lift.decay, glm::distance(basis.rest()[i], lift.at) / lift.radius);
    return out;
}

GridVertex vertex_at(const SimplexBasis<2>& basis, const std::vector<glm::dvec3>& d,
                     const glm::dvec2& x, const glm::dvec2& uv)
{
    std::vector<BasisValue<2>> values;
    basis.values_at(x, true, values);
    glm::dvec3 at(x, 0), along(1, 0, 0), across(0, 1, 0);
    for (const BasisValue<2>& each : values) {
        const glm::dvec3& by = d[static_cast<std::size_t>(each.point)];
        at += by * each.value;
        along += by * each.gradient.x;
        across += by * each.gradient.y;
    }
    return {at, unit_or(glm::cross(along, across), {0, 0, 1}), uv};
}

} // namespace

Mesh simplex_sheet(const SimplexSheetShape& shape)
{
    const SimplexMesh<2> cells = rectangle_cells(shape.size, shape.boxes);
    const SimplexBasis<2> basis(with_clouds<2>(
        cells.vertices, cells.cells, shape.degree,
        {shape.spread, shape.clamped ? CloudBorder::stacked : CloudBorder::outside}));
    const std::vector<glm::dvec3> d = displacements(basis, shape.lifts);
    const int n = shape.segments;
    const auto row = static_cast<std::size_t>(n + 1);
    std::vector<GridVertex> vertices(row * row);
    parallel_blocks(vertices.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec2 uv(static_cast<double>(i / row) / n, static_cast<double>(i % row) / n);
            vertices[i] = vertex_at(basis, d, (uv - 0.5) * shape.size, uv);
        }
    });
    Mesh mesh;
    append_grid(mesh, glm::ivec2(n), [&](int i, int j) {
        return vertices[static_cast<std::size_t>(i) * row + static_cast<std::size_t>(j)];
    });
    return finished_grids(std::move(mesh));
}

} // namespace trivar
