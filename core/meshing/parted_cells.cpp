// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/parted_cells.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/meshing/box_lines.h"
#include "core/meshing/mesher_cells.h"
#include "core/meshing/round_slivers.h"
#include "core/simplex/cell_faces.h"

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
constexpr double round_enough = 0.004; // radians: 0.2 degrees
constexpr double sliver_bound = 0.15;  // radians: 8.6 degrees
constexpr double on_boundary = 1e-5;   // of the box
constexpr double off_boundary = 0.1;   // edges
constexpr double lines_per_edge = 3;
constexpr int beyond = 0, outside_label = 1, inside_label = 2;

// The lengths for faces and edges of the box and for those of the boundary in it.
struct Sizing {
    using FT = Kernel::FT;
    using Point_3 = Kernel::Point_3;
    using Index = Domain::Index;
    double of_box, of_boundary;
    Domain::Curve_index last_of_box = 0;
    FT operator()(const Point_3&, int, const Index& index) const
    {
        if (const auto* curve = boost::get<Domain::Curve_index>(&index))
            return *curve > last_of_box ? of_boundary : of_box;
        const auto* patch = boost::get<Domain::Surface_patch_index>(&index);
        return patch && patch->first != beyond && patch->second != beyond ? of_boundary : of_box;
    }
};

std::vector<std::vector<Kernel::Point_3>> polylines(const std::vector<BoxLines::Line>& lines)
{
    std::vector<std::vector<Kernel::Point_3>> out;
    for (const BoxLines::Line& line : lines) {
        out.emplace_back();
        for (const glm::dvec3& p : line) out.back().emplace_back(p.x, p.y, p.z);
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

bool on_side(double x, double side, double whole)
{
    return std::abs(x - side) < 2 * on_boundary * whole;
}

// Puts vertices on the faces of the box, up to the mesher's accuracy, exactly there.
void put_on_box(SimplexMesh<3>& mesh, const Box& box)
{
    const double whole = glm::length(box.size());
    for (glm::dvec3& v : mesh.vertices)
        for (int i = 0; i < 3; ++i)
            for (const double side : {box.lo[i], box.hi[i]})
                if (on_side(v[i], side, whole)) v[i] = side;
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

glm::dvec3 middle(Complex::Cell_handle cell)
{
    glm::dvec3 out(0);
    for (int i = 0; i < 4; ++i) {
        const auto& p = cell->vertex(i)->point();
        out += glm::dvec3(p.x(), p.y(), p.z()) / 4.0;
    }
    return out;
}

// All cells of the triangulation, but flat ones on sides of the box, fill it. The mesher leaves out
// those whose circumcentre is not in the box, as there are where the boundary meets it at a sharp
// angle, and takes some of the flat ones.
std::vector<Complex::Cell_handle> cells_of(const Complex& complex, const Box& box)
{
    const double whole = glm::length(box.size());
    const auto flat = [&](Complex::Cell_handle cell) {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {box.lo[axis], box.hi[axis]}) {
                int there = 0;
                for (int i = 0; i < 4; ++i)
                    there += on_side(cell->vertex(i)->point()[axis], side, whole) ? 1 : 0;
                if (there == 4) return true;
            }
        return false;
    };
    std::vector<Complex::Cell_handle> out;
    for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c)
        if (!flat(c)) out.push_back(c);
    for (const Complex::Cell_handle cell : complex.triangulation().finite_cell_handles())
        if (!complex.is_in_complex(cell) && !flat(cell)) out.push_back(cell);
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
    const double edge = parting.edge, fine = parting.boundary_edge;
    const BoxLines lines = box_lines(box, parting.inside, fine / lines_per_edge);
    const auto edges = polylines(lines.edges), met = polylines(lines.boundary);
    std::vector<Domain::Curve_index> numbers;
    domain.add_features(edges.begin(), edges.end(), std::back_inserter(numbers));
    domain.add_features(met.begin(), met.end());
    const Criteria criteria(
        Options::edge_size = Sizing{edge, fine, numbers.back()}, Options::facet_angle = 25,
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
        throw Rejected("The box could not be filled with cells along the boundary.");
    }
    if (error != CGAL::CGAL_MESH_3_NO_ERROR)
        throw Rejected(
            fmt::format("The boundary needs more than {} cells.", with_commas(parting.cell_limit)));
    const std::vector<Complex::Cell_handle> all = cells_of(complex, box);
    MesherCells cells = mesher_cells(complex, all);
    PartedCells out{std::move(cells.mesh), {}};
    for (const auto c : all)
        out.inside.push_back(complex.is_in_complex(c) ? complex.subdomain_index(c) == inside_label
                                                      : parting.inside(middle(c)));
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
    for (const double shorter : {0.93, 0.86}) {
        if (most >= round_enough) break;
        CellParting parting = asked;
        parting.edge *= shorter;
        parting.boundary_edge *= shorter;
        parting.cell_limit *= 2; // of what was asked for there were few enough
        PartedCells cells;
        try {
            cells = filled(parting);
        } catch (const Rejected&) { // what there is will do
            continue;
        }
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
