// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/boundary_fit.h"

#include "core/simplex/cell_faces.h"
#include "core/simplex/cell_lattice.h"
#include "core/simplex/simplex_domain.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int fitting_sweeps = 3;
constexpr double least_volume_share = 0.25; // of a cell's volume
constexpr double farthest = 0.5;            // edges that a face may be off the boundary
// Where a face is compared with the boundary: the middle, and the middles of its thirds.
constexpr std::array<std::array<double, 3>, 4> compared_places{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}}};

using Inside = std::function<bool(const glm::dvec3&)>;

double signed_volume(const SimplexMesh<3>& mesh, int cell)
{
    std::array<glm::dvec3, 4> at;
    for (std::size_t k = 0; k < 4; ++k)
        at[k] =
            mesh.vertices[static_cast<std::size_t>(mesh.cells[static_cast<std::size_t>(cell)][k])];
    return orientation(at);
}

// Returns the distance to the boundary from a place inside or outside, along a direction that leads
// outside; 0 if it is nowhere near.
double boundary_along(const glm::dvec3& from, const glm::dvec3& out, double most,
                      const Inside& inside)
{
    const bool in = inside(from);
    double near = 0, far = in ? most : -most;
    if (inside(from + out * far) == in) return 0;
    for (int step = 0; step < 12; ++step) {
        const double middle = (near + far) / 2;
        (inside(from + out * middle) == in ? near : far) = middle;
    }
    return (near + far) / 2;
}

// Per vertex: which way to move, a sum of weights, and whether it may.
struct Wish {
    glm::dvec3 by{0};
    double weight = 0;
    bool border = false;
};

std::vector<Wish> wishes(const PartedCells& cells, const Inside& inside)
{
    const SimplexMesh<3>& mesh = cells.mesh;
    std::vector<Wish> out(mesh.vertices.size());
    SimplexDomain<3> domain;
    domain.cells = mesh.cells;
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool inner = i + 1 < faces.size() && faces[i].vertices == faces[i + 1].vertices;
        if (!inner) {
            for (const int v : faces[i].vertices) out[static_cast<std::size_t>(v)].border = true;
            continue;
        }
        const CellFace<3>& face = cells.inside[faces[i].cell] ? faces[i] : faces[i + 1];
        ++i;
        if (cells.inside[faces[i - 1].cell] == cells.inside[faces[i].cell]) continue;
        std::array<int, 3> numbers;
        std::array<glm::dvec3, 3> c;
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] =
                mesh.cells[face.cell][static_cast<std::size_t>(outward_faces[face.opposite][k])];
            c[k] = mesh.vertices[static_cast<std::size_t>(numbers[k])];
        }
        const glm::dvec3 area = glm::cross(c[1] - c[0], c[2] - c[0]), normal = glm::normalize(area);
        for (const auto& b : compared_places) {
            const double off = boundary_along(c[0] * b[0] + c[1] * b[1] + c[2] * b[2], normal,
                                              farthest * std::sqrt(glm::length(area)), inside);
            for (std::size_t k = 0; k < 3; ++k) {
                Wish& wish = out[static_cast<std::size_t>(numbers[k])];
                const double weight = b[k] * glm::length(area);
                wish.by += normal * (off * weight);
                wish.weight += weight;
            }
        }
    }
    return out;
}

} // namespace

PartedCells with_fitted_faces(PartedCells cells, const Inside& inside)
{
    SimplexMesh<3>& mesh = cells.mesh;
    const std::vector<std::vector<int>> stars = vertex_stars(mesh);
    std::vector<double> least;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        least.push_back(least_volume_share * signed_volume(mesh, static_cast<int>(c)));
    for (int sweep = 0; sweep < fitting_sweeps; ++sweep) {
        const std::vector<Wish> all = wishes(cells, inside);
        for (std::size_t v = 0; v < all.size(); ++v) {
            if (all[v].weight == 0 || all[v].border) continue;
            const glm::dvec3 from = mesh.vertices[v];
            mesh.vertices[v] += all[v].by / all[v].weight;
            const bool fits = std::all_of(stars[v].begin(), stars[v].end(), [&](int c) {
                return signed_volume(mesh, c) >= least[static_cast<std::size_t>(c)];
            });
            if (!fits) mesh.vertices[v] = from;
        }
    }
    return cells;
}

} // namespace trivar
