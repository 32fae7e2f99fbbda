// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/grid_mesh.h"
#include "core/mesh/primitives.h"
#include "core/mesh/teapot_patches.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double newell_height = 3.15;

using Weights = std::array<double, 4>;

// Computes the Bernstein polynomials of degree 3 at i / n. They are functions of i / n and (n - i)
// / n, so that i and n - i give the same numbers mirrored: neighbours with opposite directions
// along a common side then meet bit for bit.
Weights bernstein(int i, int n)
{
    const double t = double(i) / n, s = double(n - i) / n;
    return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}

Weights bernstein_derivative(int i, int n)
{
    const double t = double(i) / n, s = double(n - i) / n;
    return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

// Adds up from both ends, so that the sum is symmetric for the same reason.
glm::dvec3 sum(const Weights& w, const std::array<glm::dvec3, 4>& p)
{
    return (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);
}

glm::dvec3 patch_sum(std::size_t patch, const Weights& rows, const Weights& columns)
{
    std::array<glm::dvec3, 4> row;
    for (std::size_t r = 0; r < 4; ++r) {
        std::array<glm::dvec3, 4> p;
        for (std::size_t c = 0; c < 4; ++c)
            p[c] = glm::dvec3(teapot_points[teapot_patches[patch][4 * r + c]]);
        row[r] = sum(columns, p);
    }
    return sum(rows, row);
}

GridVertex patch_vertex(std::size_t patch, int i, int j, int n)
{
    const Weights row = bernstein(j, n), column = bernstein(i, n);
    const Weights d_row = bernstein_derivative(j, n), d_column = bernstein_derivative(i, n);
    GridVertex vertex{patch_sum(patch, row, column), {}, {double(i) / n, double(j) / n}};
    const glm::dvec3 along = patch_sum(patch, d_row, column);
    glm::dvec3 across = patch_sum(patch, row, d_column);
    // At the top of the lid and the centre of the bottom a whole row is one point: near it `across`
    // grows with the mixed derivative.
    if (glm::length(across) < 1e-9) across = patch_sum(patch, d_row, d_column);
    vertex.normal = glm::normalize(glm::cross(along, across));
    return vertex;
}

} // namespace

Mesh teapot_mesh(double height, int resolution)
{
    if (!(height >= 1e-9 && height <= 1e9))
        throw Rejected(
            fmt::format("the height of the teapot must be between 1e-9 and 1e9, not {}", height));
    if (resolution < 1 || resolution > 64)
        throw Rejected(
            fmt::format("the resolution of the teapot must be 1 to 64, not {}", resolution));
    Mesh mesh;
    for (std::size_t patch = 0; patch < teapot_patches.size(); ++patch)
        append_grid(
            mesh, glm::ivec2(resolution),
            [&](int i, int j) {
                GridVertex vertex = patch_vertex(patch, i, j, resolution);
                vertex.position *= height / newell_height;
                return vertex;
            },
            true);
    return finished_grids(std::move(mesh));
}

} // namespace trivar
