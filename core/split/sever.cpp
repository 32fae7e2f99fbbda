// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/sever.h"

#include "core/base/parallel.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/joined_borders.h"
#include "core/split/cap.h"
#include "core/split/halve_edges.h"
#include "core/split/rim_loops.h"
#include "core/split/split_error.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t heights_per_turn = 1 << 12;
constexpr int most_edge_halvings = 16;
constexpr double share_of_tolerance = 0.8;
constexpr double least_thickness = 1e-6; // of the mesh's size

// Heights of the vertices that have none yet.
void measure(std::vector<double>& heights, const Mesh& mesh, const CutSheet& sheet)
{
    const std::size_t first = heights.size();
    heights.resize(mesh.vertex_count());
    parallel_blocks(heights.size() - first, heights_per_turn,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t v = first + begin; v < first + end; ++v)
                            heights[v] = sheet.height(sheet.uvw(glm::dvec3(mesh.positions[v])));
                    });
}

// Returns the distance from the surface, in units of the cut's space, at which a vertex counts as
// lying on it: nearer ones cannot be told from one on it, as after a turn that was rounded.
double on_surface(const Mesh& mesh, const CutSheet& sheet)
{
    const Box box = bounding_box(mesh);
    if (box.empty()) return 0;
    Box there;
    double furthest = 0;
    for (const glm::dvec3& corner : box.corners()) {
        there.add(sheet.uvw(corner));
        for (int i = 0; i < 3; ++i) furthest = std::max(furthest, std::abs(corner[i]));
    }
    const double unit = glm::length(there.size()) / glm::length(box.size());
    return std::max(least_thickness * glm::length(there.size()),
                    double{std::numeric_limits<float>::epsilon()} * furthest * unit);
}

// Joins corners of a mesh that are all but at one place; false: there are none.
bool join_borders(Mesh& mesh)
{
    const Adjacency adjacency(mesh);
    std::vector<std::uint32_t> border;
    for (std::size_t e = 0; e < adjacency.edge_count(); ++e)
        if (adjacency.is_border(e))
            border.insert(border.end(), {adjacency.edges()[e].x, adjacency.edges()[e].y});
    JoinedBorders joined = with_joined_borders(std::move(mesh), std::move(border));
    mesh = std::move(joined.mesh);
    return joined.any;
}

// Halves edges of triangles through which a curved surface goes, until all are fine enough.
// Returns the bound of how far the cut is from the surface.
double make_fine(Mesh& mesh, std::vector<double>& heights, const CutSheet& sheet,
                 const SeverOptions& options)
{
    mesh = triangulated(std::move(mesh));
    std::vector<std::uint32_t> open(mesh.face_count());
    std::iota(open.begin(), open.end(), 0u);
    const double tolerance = share_of_tolerance * options.tolerance;
    double fine = 0;
    for (int round = 0;; ++round) {
        EdgeNumbers marked;
        double worst = 0;
        for (const std::uint32_t f : open) {
            const std::uint32_t* const c = mesh.corners.data() + 3 * std::size_t{f};
            std::array<glm::dvec2, 3> vw;
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 uvw = sheet.uvw(glm::dvec3(mesh.positions[c[i]]));
                vw[i] = {uvw.y, uvw.z};
            }
            const std::array<double, 3> bends = sheet.bends(vw);
            const double off = share_of_bend * std::ranges::max(bends);
            const auto [least, most] = std::minmax({heights[c[0]], heights[c[1]], heights[c[2]]});
            if (least > off || most < -off) continue; // the surface does not meet it
            worst = std::max(worst, off);
            if (off <= tolerance) {
                fine = std::max(fine, off);
                continue;
            }
            for (std::size_t i = 0; i < 3; ++i)
                if (share_of_bend * bends[i] > tolerance)
                    marked.add(mesh.point(c[i]), mesh.point(c[(i + 1) % 3]));
        }
        if (marked.count() == 0) return fine;
        if (round >= most_edge_halvings || mesh.face_count() >= options.most_triangles)
            return worst;
        open = halve_edges(mesh, point_count(mesh), marked);
        measure(heights, mesh, sheet);
    }
}

// Where caps get values of morph targets: from the rim of the same half, by the copies of the edges
// that were cut; points inside from all of these, the nearer the more.
void carry_to_caps(CutMesh& cut, const Caps& caps)
{
    const std::size_t places = cut.places.size();
    const std::size_t per_half = (cut.mesh.vertex_count() - caps.first_vertex) / 2;
    for (Mesh::MorphTarget& target : cut.mesh.morph_targets)
        for (std::size_t half = 0; half < 2; ++half)
            for (std::size_t k = 0; k < per_half && !target.positions.empty(); ++k) {
                const std::size_t first = caps.first_vertex + half * per_half;
                if (k < places) {
                    target.positions[first + k] =
                        target.positions[cut.first_vertex + 2 * cut.edge_of_place[k] + half];
                    continue;
                }
                glm::dvec3 sum(0);
                double all = 0;
                for (std::size_t p = 0; p < places; ++p) {
                    const glm::dvec2 way = caps.parameters[k] - caps.parameters[p];
                    const double weight = 1 / std::max(1e-300, glm::dot(way, way));
                    sum += weight * glm::dvec3(target.positions[first + p]);
                    all += weight;
                }
                target.positions[first + k] = glm::vec3(sum / all);
            }
}

// The faces of one half, with the vertices that they use.
Mesh half_of(const CutMesh& cut, bool above)
{
    const Mesh& all = cut.mesh;
    Mesh out = all;
    out.corners.clear();
    out.face_begin = {0};
    out.face_material.clear();
    out.face_group.clear();
    for (std::size_t f = 0; f < all.face_count(); ++f) {
        const std::uint32_t begin = all.face_begin[f], end = all.face_begin[f + 1];
        if ((cut.above[all.corners[begin]] != 0) != above) continue;
        add_face(out, {all.corners.data() + begin, end - begin});
        if (!all.face_material.empty()) out.face_material.push_back(all.face_material[f]);
        if (!all.face_group.empty()) out.face_group.push_back(all.face_group[f]);
    }
    return without_loose_vertices(std::move(out));
}

} // namespace

std::optional<Severed> sever(const Mesh& given, const CutSheet& sheet, const SeverOptions& options,
                             Unsevered& unsevered)
{
    unsevered = {};
    if (given.positions.empty()) return std::nullopt;
    std::vector<double> heights;
    measure(heights, given, sheet);
    const OnCut on{on_surface(given, sheet), [&](const glm::dvec3& p) {
                       const glm::dvec3 uvw = sheet.uvw(p);
                       return sheet.normal({uvw.y, uvw.z});
                   }};
    const auto [least, most] = std::ranges::minmax(heights);
    unsevered = {least >= -on.within, least <= on.within && most >= -on.within};
    // Between vertices on one side a curved surface may still go through
    if (sheet.is_flat() && (unsevered.above || most <= on.within)) return std::nullopt;

    Mesh mesh = given;
    mesh.creases.clear();
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    Severed out;
    if (!sheet.is_flat()) out.off = make_fine(mesh, heights, sheet, options);
    CutMesh cut_mesh = cut(mesh, heights, {}, nullptr, &on);
    if (!loops_of(cut_mesh.rim, cut_mesh.places.size()).open.empty() && join_borders(mesh)) {
        heights.clear();
        measure(heights, mesh, sheet);
        cut_mesh = cut(mesh, heights, {}, nullptr, &on);
    }
    if (cut_mesh.rim.empty()) {
        std::array<bool, 2> any{};
        for (std::size_t f = 0; f < cut_mesh.mesh.face_count(); ++f)
            any[cut_mesh.above[cut_mesh.mesh.corners[cut_mesh.mesh.face_begin[f]]] ? 1 : 0] = true;
        unsevered.above = any[1];
        if (!any[0] || !any[1]) return std::nullopt;
    }
    if (options.capped) {
        CapOptions closing;
        for (const glm::vec3& place : cut_mesh.places) {
            const glm::dvec3 uvw = sheet.uvw(glm::dvec3(place));
            closing.places.emplace_back(uvw.y, uvw.z);
        }
        const auto off = [&](const std::array<glm::dvec2, 3>& vw) {
            return share_of_bend * std::ranges::max(sheet.bends(vw));
        };
        closing.point = [&](const glm::dvec2& vw) { return sheet.point(vw); };
        closing.normal = [&](const glm::dvec2& vw) { return sheet.normal(vw); };
        if (!sheet.is_flat())
            closing.coarseness = [&](const std::array<glm::dvec2, 3>& vw) {
                std::array<double, 3> edges = sheet.bends(vw);
                for (double& each : edges) each *= share_of_bend / options.tolerance;
                return TriangleCoarseness{edges, std::ranges::max(edges)};
            };
        closing.material = options.material;
        const Caps caps = cap(cut_mesh, closing);
        carry_to_caps(cut_mesh, caps);
        out.fans = caps.fans;
        out.open = caps.open;
        out.gaps = caps.gaps;
        for (std::size_t f = caps.first_face; f < cut_mesh.mesh.face_count(); ++f) {
            std::array<glm::dvec2, 3> vw;
            for (std::size_t i = 0; i < 3; ++i)
                vw[i] = caps.parameters[cut_mesh.mesh.corners[cut_mesh.mesh.face_begin[f] + i] -
                                        caps.first_vertex];
            out.off = std::max(out.off, off(vw));
        }
    }
    for (const bool up : {false, true}) out.halves[up ? 1 : 0] = half_of(cut_mesh, up);
    return out;
}

} // namespace trivar
