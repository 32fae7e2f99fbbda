// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/fitted_volume.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/meshing/boundary_fit.h"
#include "core/meshing/parted_cells.h"
#include "core/simplex/cell_search.h"
#include "core/simplex/clouds.h"
#include "core/simplex/field_surface.h"
#include "core/simplex/multi_index.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace trivar {
namespace {

constexpr double samples_per_coefficient = 100;
constexpr double volume_per_cell = 0.05; // edge^3, as the mesher makes them
// The number of coefficients per cell by degree. In large meshes there are 0.18 vertices, 1.18
// edges and 2 faces to a cell.
constexpr std::array<double, 4> coefficients_per_cell{0, 0.18, 1.36, 4.5};
constexpr int most_trials = 8;
constexpr int pieces = 4; // along an edge of a cell, of its surface

struct Domain {
    PartedCells cells;
    SimplexDomain<3> domain;
    std::size_t coefficients = 0;
};

Domain domain_of(const CellParting& parting, int degree)
{
    Domain out{with_fitted_faces(parted_cells(parting), parting.inside), {}};
    out.domain = with_clouds<3>(out.cells.mesh.vertices, out.cells.mesh.cells, degree, {},
                                cuts_between(out.cells, degree));
    out.coefficients = fit_size(out.domain);
    return out;
}

// Meshes until the coefficients are nearly as many as wanted, and not more.
Domain domain_of(CellParting parting, const TetrahedraFit& fit)
{
    const glm::dvec3 size = parting.box.size();
    const double wanted = fit.coefficients,
                 cells = wanted / coefficients_per_cell[static_cast<std::size_t>(fit.degree)];
    parting.edge = std::cbrt(size.x * size.y * size.z / (volume_per_cell * cells));
    parting.cell_limit = static_cast<std::size_t>(20 * cells) + 1000;
    std::optional<Domain> best;
    for (int trial = 0; trial < most_trials; ++trial) {
        parting.boundary_edge = parting.edge / 2;
        Domain made;
        try {
            made = domain_of(parting, fit.degree);
        } catch (const Rejected& error) { // other lengths did
            if (best) break;
            throw Rejected(fmt::format(
                "{} Another boundary, or another number of coefficients, may do.", error.what()));
        }
        const double share = static_cast<double>(made.coefficients) / wanted;
        if (share <= 1 && (!best || made.coefficients > best->coefficients)) best = std::move(made);
        if (share > 0.9 && share <= 1) break;
        parting.edge *= std::cbrt(share / 0.95);
    }
    if (!best)
        throw Rejected(fmt::format("The boundary is too long for {} coefficients: it needs more.",
                                   fit.coefficients));
    return std::move(*best);
}

int stride_for(const glm::ivec3& size, double most)
{
    const auto count = [&](int stride) {
        const glm::dvec3 n = glm::floor(glm::dvec3(size - 1) / static_cast<double>(stride)) + 1.0;
        return n.x * n.y * n.z;
    };
    int stride = 1;
    while (count(stride) > most) ++stride;
    return stride;
}

// 1 inside and -1 outside.
SimplexField sides(const FittedVolume& volume)
{
    SimplexField out = volume.field;
    const std::size_t per_cell = multi_indices<3>(out.basis->domain().degree).size();
    for (std::size_t c = 0; c < volume.inside.size(); ++c)
        for (std::size_t i = 0; i < per_cell; ++i)
            out.values[static_cast<std::size_t>(out.basis->point_of(c, i))] =
                volume.inside[c] ? 1 : -1;
    return out;
}

} // namespace

FittedVolume fitted_volume(const VoxelField& volume, const TetrahedraFit& fit)
{
    const ScalarField<float>& field = volume.field();
    const auto boundary = static_cast<float>(volume.grid().sample(fit.boundary));
    if (fit.degree < 1 || fit.degree > max_simplex_degree || fit.coefficients < 100)
        throw Rejected("A fit needs a degree of 1 to 3 and at least 100 coefficients.");
    const auto inside = [&](const glm::dvec3& p) {
        return field.at<0>(glm::clamp(glm::vec3(p), glm::vec3(0), field.end())).value >= boundary;
    };
    // half a voxel more, so that no sample is on the border
    const Box box{glm::dvec3(-0.5), glm::dvec3(field.size()) - 0.5};
    Domain made = domain_of({.box = box, .inside = inside}, fit);
    const CellSearch search(made.cells.mesh);
    const glm::ivec3 size = field.size();
    const int stride = stride_for(size, samples_per_coefficient * fit.coefficients);
    const glm::ivec3 count = (size - 1) / stride + 1;
    std::vector<std::vector<FieldSample>> layers(static_cast<std::size_t>(count.z));
    std::vector<std::size_t> left_out(layers.size());
    parallel_blocks(layers.size(), 1, [&](std::size_t k, std::size_t) {
        for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i) {
                const glm::ivec3 at = glm::ivec3(i, j, static_cast<int>(k)) * stride;
                const float value = field.at<0>(glm::vec3(at)).value;
                const int cell = search.cell_at(glm::dvec3(at));
                if (cell < 0) continue;
                if (made.cells.inside[static_cast<std::size_t>(cell)] == (value >= boundary))
                    layers[k].push_back({glm::dvec3(at), static_cast<double>(value)});
                else
                    ++left_out[k];
            }
    });
    std::vector<FieldSample> samples;
    FittedVolume out;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        samples.insert(samples.end(), layers[k].begin(), layers[k].end());
        out.left_out += left_out[k];
    }
    FieldFit fitted = fitted_field(make_ref(SimplexBasis<3>(std::move(made.domain))), samples);
    out.field = std::move(fitted.field);
    out.inside = std::move(made.cells.inside);
    out.boundary = static_cast<double>(boundary);
    out.coefficients = fitted.coefficients;
    out.rms = fitted.rms;
    return out;
}

Mesh fitted_surface(const FittedVolume& volume, const VoxelGrid& grid, double level, LevelSide side,
                    const glm::dmat4& to_space)
{
    const double at = grid.sample(level);
    const bool above = (side == LevelSide::above) == (grid.slope > 0);
    SimplexField field = volume.field;
    if (static_cast<float>(at) == static_cast<float>(volume.boundary))
        field = sides(volume);
    else
        for (double& value : field.values) value -= at;
    if (!above)
        for (double& value : field.values) value = -value;
    return transformed(field_surface(field, volume.inside, 0, pieces), to_space);
}

} // namespace trivar
