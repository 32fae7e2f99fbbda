// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/parted_cells.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/mesher_cells.h"
#include "core/simplex/round_slivers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Mesh_domain_with_polyline_features_3<CGAL::Labeled_mesh_domain_3<Kernel>>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                        Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
namespace Options = CGAL::parameters;

constexpr double radius_of_edge = 0.6; // the regular tetrahedron's circumradius is 0.61 edges
constexpr double round_enough = 0.02;  // radians: a degree
constexpr double sliver_bound = 0.15;  // radians: 8.6 degrees
constexpr double on_boundary = 1e-5;   // of the box
constexpr double off_boundary = 0.1;   // edges
constexpr int beyond = 0, outside_label = 1, inside_label = 2;

// The lengths for faces of the box and for those of the boundary in it.
struct Sizing {
    using FT = Kernel::FT;
    using Point_3 = Kernel::Point_3;
    using Index = Domain::Index;
    double of_box, of_boundary;
    FT operator()(const Point_3&, int, const Index& index) const
    {
        const auto* patch = boost::get<Domain::Surface_patch_index>(&index);
        return patch && patch->first != beyond && patch->second != beyond ? of_boundary : of_box;
    }
};

std::vector<std::vector<Kernel::Point_3>> edges_of(const Box& box)
{
    std::vector<std::vector<Kernel::Point_3>> out;
    const auto put = [](const glm::dvec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool u : {false, true})
            for (const bool v : {false, true}) {
                glm::dvec3 a = box.lo;
                if (u) a[(axis + 1) % 3] = box.hi[(axis + 1) % 3];
                if (v) a[(axis + 2) % 3] = box.hi[(axis + 2) % 3];
                glm::dvec3 b = a;
                b[axis] = box.hi[axis];
                out.push_back({put(a), put(b)});
            }
    return out;
}

void check(const CellParting& p)
{
    const double whole = glm::length(p.box.size());
    if (p.box.empty() || !(whole > 0) || !std::isfinite(whole))
        throw Rejected("The box to fill with cells is empty.");
    if (!(p.edge > 0) || !(p.boundary_edge > 0) || p.boundary_edge > p.edge)
        throw Rejected("Edges of cells must be longer than 0, and those on the boundary not longer "
                       "than the others.");
    if (p.boundary_edge < 1e-3 * whole)
        throw Rejected("Edges of cells must be longer than 1/1,000 of the box.");
}

// The nearest place on a face of the box.
glm::dvec3 on_box(const glm::dvec3& p, const Box& box)
{
    glm::dvec3 out = p;
    double least = infinite;
    for (int i = 0; i < 3; ++i)
        for (const double side : {box.lo[i], box.hi[i]})
            if (std::abs(p[i] - side) < least) {
                least = std::abs(p[i] - side);
                out = p;
                out[i] = side;
            }
    return out;
}

// Vertices on the faces of the box, to what the mesher finds them by, are put exactly there; then
// others of the border, too: the mesher leaves some inside where the boundary meets the box. Those
// that would flatten a cell stay.
void put_on_box(SimplexMesh<3>& mesh, const Box& box)
{
    const double near = 2 * on_boundary * glm::length(box.size());
    for (glm::dvec3& v : mesh.vertices)
        for (int i = 0; i < 3; ++i)
            for (const double side : {box.lo[i], box.hi[i]})
                if (std::abs(v[i] - side) < near) v[i] = side;
    const std::vector<std::vector<int>> stars = vertex_stars(mesh);
    const auto volume = [&](int cell) {
        std::array<glm::dvec3, 4> at;
        for (std::size_t k = 0; k < 4; ++k)
            at[k] = mesh.vertices[static_cast<std::size_t>(
                mesh.cells[static_cast<std::size_t>(cell)][k])];
        return orientation(at);
    };
    SimplexDomain<3> domain;
    domain.cells = mesh.cells;
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (f + 1 < faces.size() && faces[f].vertices == faces[f + 1].vertices) {
            ++f;
            continue;
        }
        for (const int number : faces[f].vertices) {
            glm::dvec3& v = mesh.vertices[static_cast<std::size_t>(number)];
            const glm::dvec3 from = v;
            const auto& star = stars[static_cast<std::size_t>(number)];
            double least = infinite;
            for (const int c : star) least = std::min(least, volume(c));
            v = on_box(v, box);
            if (!std::all_of(star.begin(), star.end(),
                             [&](int c) { return volume(c) > 0.25 * least; }))
                v = from;
        }
    }
}

// Along which axes vertices may move: within the parts along all, in a face of the box along two,
// on the boundary along none.
std::vector<std::uint8_t> free_axes(const SimplexMesh<3>& mesh, const std::vector<int>& dimension,
                                    const Box& box)
{
    std::vector<std::uint8_t> out;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        int free = 7, sides = 0;
        for (int k = 0; k < 3; ++k)
            if (const double x = mesh.vertices[v][k]; x == box.lo[k] || x == box.hi[k]) {
                free &= ~(1 << k);
                ++sides;
            }
        const bool within = dimension[v] == 3 || (dimension[v] == 2 && sides == 1);
        out.push_back(static_cast<std::uint8_t>(within ? free : 0));
    }
    return out;
}

// The cells with these lengths; some may be flat.
PartedCells filled(const CellParting& parting)
{
    const Box& box = parting.box;
    const auto label = [&](const Kernel::Point_3& p) {
        const glm::dvec3 x(p.x(), p.y(), p.z());
        if (box.distance(x) > 0) return beyond;
        return parting.inside(x) ? inside_label : outside_label;
    };
    const glm::dvec3 more = box.size() * 0.05, lo = box.lo - more, hi = box.hi + more;
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::Random random(0);
    Domain domain(label, CGAL::Bbox_3(lo.x, lo.y, lo.z, hi.x, hi.y, hi.z),
                  Options::relative_error_bound = on_boundary, Options::p_rng = &random);
    const auto lines = edges_of(box);
    domain.add_features(lines.begin(), lines.end());
    const double edge = parting.edge, fine = parting.boundary_edge;
    const Criteria criteria(
        Options::edge_size = edge, Options::facet_angle = 25,
        Options::facet_size = Sizing{radius_of_edge * edge, radius_of_edge * fine},
        Options::facet_distance = Sizing{off_boundary * edge, off_boundary * fine},
        Options::cell_radius_edge_ratio = 2, Options::cell_size = radius_of_edge * edge);
    CGAL::Mesh_error_code error = CGAL::CGAL_MESH_3_NO_ERROR;
    Complex complex;
    try {
        complex = CGAL::make_mesh_3<Complex>(
            domain, criteria, Options::no_lloyd(), Options::no_odt(), Options::no_perturb(),
            Options::no_exude(), // see round_slivers()
            Options::mesh_3_options(Options::maximal_number_of_vertices = parting.cell_limit / 3,
                                    Options::pointer_to_error_code = &error));
    } catch (const CGAL::Failure_exception&) {
        throw Rejected(
            "The box could not be filled with cells along the boundary; other lengths of "
            "edges may do.");
    }
    if (error != CGAL::CGAL_MESH_3_NO_ERROR)
        throw Rejected(fmt::format("The boundary needs more than {} cells: let edges be longer.",
                                   parting.cell_limit));
    MesherCells cells = mesher_cells(complex);
    PartedCells out{std::move(cells.mesh), {}};
    for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c)
        out.inside.push_back(complex.subdomain_index(c) == inside_label);
    if (std::find(out.inside.begin(), out.inside.end(), true) == out.inside.end() ||
        std::find(out.inside.begin(), out.inside.end(), false) == out.inside.end())
        throw Rejected(
            "All of the box is on one side of the boundary, so nothing parts its cells.");
    // Before, too: a sliver may be turned over by the way to the box.
    round_slivers(out.mesh, free_axes(out.mesh, cells.dimension, box), sliver_bound);
    put_on_box(out.mesh, box);
    round_slivers(out.mesh, free_axes(out.mesh, cells.dimension, box), sliver_bound);
    return out;
}

} // namespace

// Slivers with four vertices on the boundary stay: other lengths of edges have others.
PartedCells parted_cells(const CellParting& asked)
{
    check(asked);
    PartedCells out = filled(asked);
    double most = least_dihedral(out.mesh);
    for (const double shorter : {0.93, 0.86, 0.79, 0.72}) {
        if (most >= round_enough) break;
        CellParting parting = asked;
        parting.edge *= shorter;
        parting.boundary_edge *= shorter;
        parting.cell_limit *= 2; // of what was asked for there were few enough
        PartedCells cells = filled(parting);
        const double least = least_dihedral(cells.mesh);
        if (least <= most) continue;
        most = least;
        out = std::move(cells);
    }
    check(out.mesh);
    return out;
}

std::vector<Crease<3>> cuts_between(const PartedCells& cells, int degree)
{
    std::vector<Crease<3>> out;
    SimplexDomain<3> domain;
    domain.cells = cells.mesh.cells;
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f + 1 < faces.size(); ++f)
        if (faces[f].vertices == faces[f + 1].vertices &&
            cells.inside[faces[f].cell] != cells.inside[faces[f + 1].cell])
            out.push_back({faces[f].vertices, degree});
    return out;
}

} // namespace trivar
