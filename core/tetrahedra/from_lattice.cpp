// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/from_lattice.h"

#include "core/base/box.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/cell_polynomial.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Nodes keep this share of a cell from its faces where the lattice is torn at some, so that they
// are on its own side.
constexpr double from_tear = 1e-9;

// The boxes of a lattice's spans.
struct SpanCells {
    SimplexMesh<3> mesh; // with vertices in uvw
    std::vector<Crease<3>> creases;
    bool torn = false;
};

std::vector<double> pieces_of(const Knots& knots, int pieces)
{
    const std::vector<double> breaks = knots.breaks();
    std::vector<double> out;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int p = 0; p < pieces; ++p)
            out.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * p / pieces);
    out.push_back(breaks.back());
    return out;
}

// Returns by how much the continuity of a spline of that degree drops at each place. Where only
// values are continuous, it becomes a seam that no function reaches across.
std::vector<Crease<3>> creases_at(const std::vector<double>& places, const Knots& knots, int degree)
{
    std::vector<Crease<3>> out(places.size());
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        const int multiplicity = knots.multiplicity(places[i]);
        if (multiplicity == 0) continue;
        const int smooth = knots.degree() - multiplicity; // derivatives
        out[i].seam = smooth == 0;
        out[i].depth = out[i].seam ? degree : std::clamp(degree - 1 - smooth, 0, degree);
    }
    return out;
}

SpanCells span_cells(const std::array<Knots, 3>& axes, const Conversion& how)
{
    std::array<std::vector<double>, 3> places;
    std::array<std::vector<Crease<3>>, 3> creases;
    double count = 6;
    for (std::size_t a = 0; a < 3; ++a) {
        places[a] = pieces_of(axes[a], how.pieces);
        creases[a] = creases_at(places[a], axes[a], how.degree);
        count *= static_cast<double>(places[a].size() - 1);
    }
    if (count > static_cast<double>(usual_cell_limit))
        throw Rejected(fmt::format("The lattice needs {} cells; {} are allowed.",
                                   number_text(count), with_commas(usual_cell_limit)));
    const glm::ivec3 boxes(places[0].size() - 1, places[1].size() - 1, places[2].size() - 1);
    SpanCells out;
    out.mesh = box_cells(glm::dvec3(1), boxes);
    const auto index = [&](int vertex) {
        return glm::ivec3(vertex / ((boxes.z + 1) * (boxes.y + 1)),
                          vertex / (boxes.z + 1) % (boxes.y + 1), vertex % (boxes.z + 1));
    };
    for (std::size_t v = 0; v < out.mesh.vertices.size(); ++v)
        for (int a = 0; a < 3; ++a)
            out.mesh.vertices[v][a] =
                places[static_cast<std::size_t>(a)]
                      [static_cast<std::size_t>(index(static_cast<int>(v))[a])];
    for (const auto& cell : out.mesh.cells)
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            std::array<int, 3> face{};
            for (std::size_t k = 0, n = 0; k < 4; ++k)
                if (k != opposite) face[n++] = cell[k];
            const glm::ivec3 a = index(face[0]), b = index(face[1]), c = index(face[2]);
            for (int axis = 0; axis < 3; ++axis) {
                if (a[axis] != b[axis] || b[axis] != c[axis]) continue;
                Crease<3> crease =
                    creases[static_cast<std::size_t>(axis)][static_cast<std::size_t>(a[axis])];
                if (crease.depth == 0) continue;
                crease.face = face;
                out.creases.push_back(crease);
                out.torn = out.torn || (crease.depth == how.degree && !crease.seam);
            }
        }
    return out;
}

glm::dvec3 blend(const std::array<glm::dvec3, 4>& corners, const glm::dvec4& l)
{
    return corners[0] * l[0] + corners[1] * l[1] + corners[2] * l[2] + corners[3] * l[3];
}

std::array<glm::dvec3, 4> corners_of_cell(const SimplexMesh<3>& mesh, std::size_t cell)
{
    std::array<glm::dvec3, 4> out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = mesh.vertices[static_cast<std::size_t>(mesh.cells[cell][k])];
    return out;
}

CellDisplacements values_at_nodes(const Lattice& lattice, const SpanCells& cells, int degree)
{
    const CellInterpolation interpolation(degree);
    const std::size_t per_cell = interpolation.nodes().size();
    CellDisplacements out(cells.mesh.cells.size() * per_cell);
    parallel_blocks(cells.mesh.cells.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
            for (std::size_t i = 0; i < per_cell; ++i) {
                glm::dvec4 l = interpolation.nodes()[i];
                if (cells.torn) l += (glm::dvec4(0.25) - l) * from_tear;
                out[c * per_cell + i] =
                    evaluate(lattice.displacement, blend(corners_of_cell(cells.mesh, c), l)).value;
            }
    });
    return out;
}

// 35 places spread evenly over a cell, none on its faces.
std::vector<glm::dvec4> places_in_cell()
{
    std::vector<glm::dvec4> out;
    for (int a = 0; a <= 4; ++a)
        for (int b = 0; a + b <= 4; ++b)
            for (int c = 0; a + b + c <= 4; ++c)
                out.push_back(glm::dvec4(a, b, c, 4 - a - b - c) * 0.2 + 0.05);
    return out;
}

void measure(const Lattice& lattice, const SpanCells& cells, ConvertedLattice& out)
{
    constexpr std::size_t block = 16;
    const std::vector<glm::dvec4> places = places_in_cell();
    struct Part {
        double most2 = 0, sum2 = 0;
    };
    const std::size_t count = cells.mesh.cells.size();
    std::vector<Part> parts((count + block - 1) / block);
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        Part& part = parts[begin / block];
        for (std::size_t c = begin; c < end; ++c)
            for (const glm::dvec4& l : places) {
                const glm::dvec3 x = blend(corners(out.volume.layers[0]->domain(), c), l);
                const glm::dvec3 d =
                    evaluate(out.volume, x).position - x -
                    evaluate(lattice.displacement, blend(corners_of_cell(cells.mesh, c), l)).value;
                part.most2 = std::max(part.most2, glm::dot(d, d));
                part.sum2 += glm::dot(d, d);
            }
    });
    double sum2 = 0;
    for (const Part& part : parts) {
        out.most = std::max(out.most, std::sqrt(part.most2));
        sum2 += part.sum2;
    }
    out.mean = std::sqrt(sum2 / static_cast<double>(count * places.size()));
}

} // namespace

ConvertedLattice from_lattice(const Lattice& lattice, const Conversion& how)
{
    if (how.pieces < 1 || how.pieces > 100)
        throw Rejected("A span of the lattice can be cut into 1 to 100 pieces.");
    const double sign = glm::determinant(glm::dmat3(lattice.rest));
    if (!(std::abs(sign) > 0)) throw Rejected("The lattice is flat at rest.");
    SpanCells cells = span_cells(lattice.displacement.axes, how);
    if (sign < 0)
        for (auto& cell : cells.mesh.cells) std::swap(cell[2], cell[3]);
    std::vector<glm::dvec3> world;
    for (const glm::dvec3& uvw : cells.mesh.vertices)
        world.emplace_back(lattice.rest * glm::dvec4(uvw, 1));
    ConvertedLattice out;
    out.volume.layers.push_back(std::make_shared<const SimplexBasis<3>>(
        with_clouds<3>(std::move(world), cells.mesh.cells, how.degree, how.style, cells.creases)));
    out.values = values_at_nodes(lattice, cells, how.degree);
    out.volume.displacements = control_displacements(*out.volume.layers[0], out.values);
    out.creases = std::move(cells.creases);
    out.spread = how.style.spread;
    measure(lattice, cells, out);
    return out;
}

TetrahedraShape shape_of(const ConvertedLattice& converted)
{
    const SimplexDomain<3>& domain = converted.volume.layers.front()->domain();
    TetrahedraShape out;
    out.degree = domain.degree;
    out.spread = converted.spread;
    Box box;
    for (std::size_t v = 0; v < domain.vertex_count(); ++v) {
        out.vertices.push_back(domain.vertex(static_cast<int>(v)));
        box.add(out.vertices.back());
    }
    for (const auto& cell : domain.cells)
        out.cells.emplace_back(cell[0], cell[1], cell[2], cell[3]);
    for (const Crease<3>& crease : converted.creases) {
        auto alike = std::ranges::find_if(out.edits, [&](const TetrahedraEdit& edit) {
            return edit.crease->depth == crease.depth && edit.crease->seam == crease.seam;
        });
        if (alike == out.edits.end())
            alike = out.edits.insert(
                alike, {.crease = TetrahedraCrease{.radius = 1e-6 * glm::length(box.size()),
                                                   .depth = crease.depth,
                                                   .seam = crease.seam}});
        glm::dvec3 middle(0);
        for (const int v : crease.face) middle += domain.vertex(v) / 3.0;
        alike->crease->places.push_back(middle);
    }
    out.displaced = converted.values;
    out.deviation = converted.most;
    return out;
}

bool is_as_converted(const TetrahedraShape& shape)
{
    return !shape.displaced.empty() && shape.spread == Conversion{}.style.spread &&
           shape.degree == degree_of(shape.displaced.size(), shape.cells.size());
}

} // namespace trivar
