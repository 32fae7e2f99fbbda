// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/cage_cells.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/meshing/closed_surface.h"
#include "core/meshing/mesher_cells.h"
#include "core/meshing/round_slivers.h"
#include "core/simplex/simplex_domain.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

using Domain = CGAL::Mesh_domain_with_polyline_features_3<
    CGAL::Polyhedral_mesh_domain_3<CgalSurface, CgalKernel>>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                        Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
namespace Options = CGAL::parameters;

// Degrees; where the mesher cannot keep the edges that bend by more it tries the next.
constexpr std::array<double, 3> least_bends{1, 30, 181};
constexpr double radius_of_edge = 0.6;   // the regular tetrahedron's circumradius is 0.61 edges
constexpr double round_enough = 0.05;    // radians: 3 degrees
constexpr double sliver_bound = 0.18;    // radians: 10 degrees
constexpr double volume_per_cell = 0.05; // edge^3, as the mesher makes them
constexpr double cells_if_not_asked = 2000;
constexpr std::size_t most_faces = 20'000; // a few minutes for the mesher

struct Sizing {
    using FT = CgalKernel::FT;
    using Point_3 = CgalKernel::Point_3;
    using Index = Domain::Index;
    const Grading* grading;
    double share;
    FT operator()(const Point_3& p, int, const Index&) const
    {
        Box box;
        box.add(glm::dvec3(p.x(), p.y(), p.z()));
        return share * edge_in(*grading, box);
    }
};

// Each edge that bends is a line of its own, so that its ends are corners.
std::vector<std::vector<CgalKernel::Point_3>> bent_edges(const CgalSurface& surface,
                                                         double least_bend)
{
    std::vector<std::vector<CgalKernel::Point_3>> out;
    const auto normal = [&](CgalSurface::Halfedge_index h) {
        const auto& a = surface.point(surface.source(h));
        const auto& b = surface.point(surface.target(h));
        const auto& c = surface.point(surface.target(surface.next(h)));
        const glm::dvec3 u(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
        const glm::dvec3 v(c.x() - a.x(), c.y() - a.y(), c.z() - a.z());
        return glm::normalize(glm::cross(u, v));
    };
    for (const auto e : surface.edges()) {
        const auto h = surface.halfedge(e);
        const glm::dvec3 a = normal(h), b = normal(surface.opposite(h));
        if (std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) > glm::radians(least_bend))
            out.push_back({surface.point(surface.source(h)), surface.point(surface.target(h))});
    }
    return out;
}

SimplexMesh<3> meshed(const CgalSurface& surface, const Grading& grading, double least_bend)
{
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::Random random(0);
    Domain domain(surface, &random);
    const auto lines = bent_edges(surface, least_bend);
    domain.add_features(lines.begin(), lines.end());
    const Sizing edges{&grading, 1}, radii{&grading, radius_of_edge};
    const Criteria criteria(Options::edge_size = edges, Options::facet_angle = 25,
                            Options::facet_size = radii,
                            Options::facet_distance = Sizing{&grading, 0.02},
                            Options::cell_radius_edge_ratio = 2, Options::cell_size = radii);
    CGAL::Mesh_error_code error = CGAL::CGAL_MESH_3_NO_ERROR;
    const Complex complex = CGAL::make_mesh_3<Complex>(
        domain, criteria, Options::no_lloyd(), Options::no_odt(), Options::no_perturb(),
        Options::no_exude(), // see round_slivers()
        Options::mesh_3_options(Options::maximal_number_of_vertices = grading.cell_limit / 3,
                                Options::pointer_to_error_code = &error));
    if (error != CGAL::CGAL_MESH_3_NO_ERROR)
        throw Rejected(fmt::format("The cage needs more than {} cells: its edges or angles are "
                                   "too small.",
                                   with_commas(grading.cell_limit)));
    MesherCells out = mesher_cells(complex);
    std::vector<std::uint8_t> axes;
    for (const int dimension : out.dimension) axes.push_back(dimension == 3 ? 7 : 0);
    round_slivers(out.mesh, axes, sliver_bound);
    return out.mesh;
}

// Slivers of four vertices on the cage cannot be made rounder: other lengths of edges have others.
struct Roundest {
    SimplexMesh<3> mesh;
    double edge = 0; // that made it
};
Roundest roundest(const CgalSurface& surface, const Grading& asked, double least_bend)
{
    Roundest out;
    double most = -1;
    Grading grading = asked;
    for (const double shorter : {1.0, 0.93, 0.86, 0.79, 0.72, 0.65, 0.55, 0.45, 0.35}) {
        grading.edge = shorter * asked.edge;
        SimplexMesh<3> mesh;
        try {
            mesh = meshed(surface, grading, least_bend);
        } catch (const Rejected&) { // too many cells, as all shorter edges would make
            if (most < 0) throw;
            break;
        } catch (const CGAL::Failure_exception&) {
            if (most < 0) throw;
            continue;
        }
        const double least = least_dihedral(mesh);
        if (least <= most) continue;
        most = least;
        out = {std::move(mesh), grading.edge};
        if (most >= round_enough) break;
    }
    return out;
}

double volume(const SimplexMesh<3>& mesh)
{
    double out = 0;
    for (const auto& cell : mesh.cells) {
        std::array<glm::dvec3, 4> at;
        for (std::size_t k = 0; k < 4; ++k)
            at[k] = mesh.vertices[static_cast<std::size_t>(cell[k])];
        out += orientation(at) / 6;
    }
    return out;
}

} // namespace

CageCells cage_cells(std::span<const glm::dvec3> positions,
                     std::span<const std::array<int, 3>> triangles, const Grading& asked)
{
    if (triangles.size() > most_faces)
        throw Rejected(fmt::format("A cage has at most {} faces, not {}. Cells can be put around "
                                   "the model instead.",
                                   with_commas(most_faces), with_commas(triangles.size())));
    const CgalSurface surface = closed_surface(positions, triangles);
    const double inside = CGAL::Polygon_mesh_processing::volume(surface);
    Box box;
    for (const auto v : surface.vertices()) {
        const auto& p = surface.point(v);
        box.add(glm::dvec3(p.x(), p.y(), p.z()));
    }
    Grading grading = asked;
    if (grading.edge == 0)
        grading.edge = std::cbrt(inside / (volume_per_cell * cells_if_not_asked));
    check(grading, glm::length(box.size()));
    CageCells out;
    const double shortest =
        std::cbrt(inside / (volume_per_cell * static_cast<double>(grading.cell_limit)));
    out.capped = grading.edge < shortest;
    grading.edge = std::min(std::max(grading.edge, shortest), glm::length(box.size()));
    for (const double least_bend : least_bends) {
        try {
            Roundest made = roundest(surface, grading, least_bend);
            out.mesh = std::move(made.mesh);
            out.edge = made.edge;
        } catch (const CGAL::Failure_exception&) {
            continue;
        }
        check(out.mesh);
        const double off = std::abs(volume(out.mesh) - inside) / inside;
        out.exact = off < 1e-6;
        if (off < 0.05) return out;
    }
    throw Rejected("The cage could not be filled: it is too thin for such long edges, or its own "
                   "are too small.");
}

} // namespace trivar
