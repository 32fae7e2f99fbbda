// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split.h"

#include "core/base/array_copies.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh_region.h"
#include "core/split/cap.h"
#include "core/split/finer.h"
#include "core/split/sew.h"
#include "core/split/split_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {
namespace {

constexpr std::size_t vertices_per_block = 2048;

// On which side of each cut surface a vertex is, and which surfaces it lies on.
struct VertexSides {
    std::size_t openings;
    std::vector<char> sides, on; // #V x #openings

    char& side(std::size_t v, std::size_t i) { return sides[v * openings + i]; }
    char& is_on(std::size_t v, std::size_t i) { return on[v * openings + i]; }
    void resize(std::size_t vertices)
    {
        sides.resize(vertices * openings, 0);
        on.resize(vertices * openings, 0);
    }
    // Vertex v lies between a and b, which are on the same side of all surfaces before `opening`.
    void between(std::size_t v, std::size_t a, std::size_t b, std::size_t opening, bool above)
    {
        for (std::size_t i = 0; i < opening; ++i) {
            side(v, i) = side(a, i);
            is_on(v, i) = is_on(a, i) && is_on(b, i);
        }
        side(v, opening) = above;
        is_on(v, opening) = 1;
    }
};

glm::dvec2 parameters_of(const SplitFrame& frame, const glm::vec3& p_world)
{
    const glm::dvec3 uvw = frame.uvw(glm::dvec3(p_world));
    return {uvw.y, uvw.z};
}

CutNeed need_of(const Mesh& mesh, const SplitField& field, std::size_t opening)
{
    const OpeningWall& wall = field.openings[opening].walls[0];
    return {{wall.lo(), wall.hi()}, [&](std::uint32_t vertex) {
                return parameters_of(field.frame, mesh.positions[vertex]);
            }};
}

// The seam of each opening; none unless the mesh is to be stitched.
std::vector<Seam> seams_of(const Mesh& mesh, const SplitField& field, SplitClosing closing)
{
    if (closing != SplitClosing::stitched) return {};
    const std::size_t openings = field.openings.size();
    std::vector<double> all, heights(mesh.vertex_count());
    add_heights(all, mesh, field);
    std::vector<Seam> out;
    for (std::size_t i = 0; i < openings; ++i) {
        for (std::size_t v = 0; v < heights.size(); ++v) heights[v] = all[openings * v + i];
        out.push_back(seam_of(cut(mesh, heights), field, i));
    }
    return out;
}

// Leaves out the vertices that no face uses, before they are moved.
void leave_out_loose(Mesh& mesh, VertexSides& all)
{
    std::vector<char> used(mesh.vertex_count(), 0);
    for (const std::uint32_t v : mesh.corners) used[v] = 1;
    std::size_t to = 0;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        for (std::size_t i = 0; i < all.openings; ++i) {
            all.side(to, i) = all.side(v, i);
            all.is_on(to, i) = all.is_on(v, i);
        }
        ++to;
    }
    mesh = without_loose_vertices(std::move(mesh));
}

// Whether a triangle of an opening's cap lies on both sides of another one's cut surface.
bool is_across(const SplitField& field, std::size_t opening, std::size_t other,
               const std::array<glm::dvec2, 3>& vw)
{
    int above = 0;
    for (const glm::dvec2& at : vw)
        above += field.openings[other].height(
                     glm::dvec3(field.openings[opening].surface_cells.value(at), at)) >= 0;
    return above == 1 || above == 2;
}

CapOptions cap_options(const SplitField& field, std::size_t opening, const CutMesh& cut,
                       const SplitError& error, double tolerance, const SplitOptions& options)
{
    const BicubicCells& surface = field.openings[opening].surface_cells;
    CapOptions out;
    for (const glm::vec3& place : cut.places)
        out.places.push_back(parameters_of(field.frame, place));
    out.point = [&](const glm::dvec2& vw) {
        return field.frame.world(glm::dvec3(surface.value(vw), vw));
    };
    out.normal = [&](const glm::dvec2& vw) {
        const BicubicCells::Jet jet = surface.jet(vw);
        return field.frame.axes * glm::normalize(glm::dvec3(1, -jet.u, -jet.v));
    };
    const bool alone = field.openings.size() == 1;
    out.coarseness = [&error, &field, opening, tolerance,
                      alone](const std::array<glm::dvec2, 3>& vw) {
        EdgeErrors edges = error.cap(opening, vw);
        for (double& each : edges) each /= tolerance;
        if (alone && edges != EdgeErrors{}) return TriangleCoarseness{edges, whole_error(edges)};
        const auto keep_near = [&](std::size_t k, double share) {
            const EdgeErrors bends = error.surface(k, vw);
            for (std::size_t i = 0; i < 3; ++i)
                edges[i] = std::max(edges[i], bends[i] / (far_from_surface * share * tolerance));
        };
        keep_near(opening, 1);
        for (std::size_t k = opening + 1; k < field.openings.size(); ++k) // that cut it later
            if (is_across(field, opening, k, vw)) keep_near(k, share_of_cut);
        return TriangleCoarseness{edges, whole_error(edges)};
    };
    if (options.closing == SplitClosing::stitched)
        out.coarseness = [&field, opening,
                          bent = out.coarseness](const std::array<glm::dvec2, 3>& vw) {
            TriangleCoarseness both = bent(vw);
            const std::array<double, 3> beyond = reach_beyond(vw, field.openings[opening]);
            for (std::size_t i = 0; i < 3; ++i) {
                both.edges[i] = std::max(both.edges[i], beyond[i]);
                both.whole = std::max(both.whole, beyond[i]);
            }
            return both;
        };
    out.material = options.material;
    return out;
}

// Gives the vertices of caps their sides of earlier surfaces: those on the rim have them from the
// edge that was cut, those inside from the others of their triangles.
void take_sides_of_caps(VertexSides& all, const CutMesh& cut, const Caps& caps, std::size_t opening)
{
    const std::size_t places = cut.places.size();
    const std::size_t per_half = (cut.mesh.vertex_count() - caps.first_vertex) / 2;
    std::vector<char> known(cut.mesh.vertex_count() - caps.first_vertex, 0);
    for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t k = 0; k < per_half; ++k) {
            const std::size_t v = caps.first_vertex + half * per_half + k;
            all.side(v, opening) = half == 1;
            all.is_on(v, opening) = 1;
            if (k >= places) continue;
            const glm::uvec2 ends = cut.edges[cut.edge_of_place[k]];
            all.between(v, ends.x, ends.y, opening, half == 1);
            known[half * per_half + k] = 1;
        }
    if (opening == 0) return;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t f = caps.first_face; f < cut.mesh.face_count(); ++f) {
            const std::uint32_t* const c = cut.mesh.corners.data() + cut.mesh.face_begin[f];
            for (int i = 0; i < 3; ++i) {
                const std::size_t from = c[i] - caps.first_vertex;
                const std::size_t to = c[(i + 1) % 3] - caps.first_vertex;
                if (!known[from] || known[to]) continue;
                for (std::size_t o = 0; o < opening; ++o)
                    all.side(c[(i + 1) % 3], o) = all.side(c[i], o);
                known[to] = 1;
                changed = true;
            }
        }
    }
}

// Moves vertex v, which is at `rest`, in uvw as well.
void move_vertex(Mesh& mesh, std::size_t v, const glm::vec3& rest, const glm::dvec3& uvw,
                 const SplitField& field, std::span<const char> sides, std::span<const char> on)
{
    const SplitField::Moved moved = field.moved(uvw, sides, on);
    if (moved.u == uvw.x && moved.gradient == glm::dvec3(1, 0, 0)) return;
    mesh.positions[v] = glm::vec3(glm::dvec3(rest) + field.frame.axes[0] * (moved.u - uvw.x));
    const glm::dmat3 to_uvw = glm::transpose(field.frame.axes);
    const glm::dvec3& g = moved.gradient;
    if (!mesh.normals.empty()) {
        // Transforms the normal by the cofactors of the derivative, whose last two rows are those
        // of the identity.
        const glm::dvec3 n = to_uvw * glm::dvec3(mesh.normals[v]);
        mesh.normals[v] =
            glm::vec3(field.frame.axes * glm::normalize(glm::dvec3(n.x, g.x * n.y - g.y * n.x,
                                                                   g.x * n.z - g.z * n.x)));
    }
    if (!mesh.tangents.empty()) {
        glm::dvec3 t = to_uvw * glm::dvec3(mesh.tangents[v]);
        t.x = glm::dot(g, t);
        t = field.frame.axes * t;
        if (glm::length(t) > 0)
            mesh.tangents[v] = glm::vec4(glm::vec3(glm::normalize(t)), mesh.tangents[v].w);
    }
}

// Moves the vertices that have no rest position yet, and gives them theirs.
void move(Mesh& mesh, std::vector<glm::vec3>& rest, const SplitField& field,
          const std::vector<Seam>& seams, VertexSides& all)
{
    const Box reach = field.reach();
    const std::size_t first = rest.size();
    rest.insert(rest.end(), mesh.positions.begin() + static_cast<long>(first),
                mesh.positions.end());
    parallel_blocks(rest.size() - first, vertices_per_block,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t v = first + begin; v < first + end; ++v) {
                            const glm::dvec3 uvw = field.frame.uvw(glm::dvec3(rest[v]));
                            if (glm::any(glm::lessThan(uvw, reach.lo)) ||
                                glm::any(glm::greaterThan(uvw, reach.hi)))
                                continue;
                            const std::span<const char> sides(&all.side(v, 0), all.openings);
                            const std::span<const char> on(&all.is_on(v, 0), all.openings);
                            if (seams.empty())
                                move_vertex(mesh, v, rest[v], uvw, field, sides, on);
                            else
                                move_sewn(mesh, v, field, seams, sides, on);
                        }
                    });
}

// The greatest of the bounds of the triangles of caps.
double bound_of(const CutMesh& cut, const Caps& caps, const SplitError& error, std::size_t opening)
{
    double most = 0;
    for (std::size_t f = caps.first_face; f < cut.mesh.face_count(); ++f) {
        std::array<glm::dvec2, 3> vw;
        for (std::size_t i = 0; i < 3; ++i)
            vw[i] =
                caps.parameters[cut.mesh.corners[cut.mesh.face_begin[f] + i] - caps.first_vertex];
        most = std::max(most, whole_error(error.cap(opening, vw)));
    }
    return most;
}

// Returns the greatest distance of a cut from its surface where that opens.
double beside(const CutMesh& cut, const SplitField& field, std::size_t opening)
{
    double most = 0;
    for (std::size_t i = 0; i < cut.places.size(); ++i)
        if (cut.moved[i] > most &&
            !field.openings[opening].beyond_walls(parameters_of(field.frame, cut.places[i])))
            most = cut.moved[i];
    return most;
}

// Moves the vertices in reach that are not among those of the region, which were moved with it.
void move_others(Mesh& out, const Mesh& whole, const MeshRegion& region, const VertexPlaces& places,
                 const SplitField& field)
{
    const std::size_t openings = field.openings.size();
    const std::size_t others = openings - std::min<std::size_t>(openings, places.surfaces_in_bits);
    const std::vector<char> on(openings, 0);
    parallel_blocks(
        whole.vertex_count(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
            std::vector<char> sides(openings);
            auto moved = std::ranges::lower_bound(region.vertices, begin);
            for (std::size_t v = begin; v < end; ++v) {
                if (moved != region.vertices.end() && *moved == v) {
                    ++moved;
                    continue;
                }
                if ((places.bits[v] & places.beyond_any) != 0) continue;
                for (std::size_t i = 0; i < openings; ++i)
                    sides[i] = i < places.surfaces_in_bits
                                   ? (places.bits[v] >> (places.first_above + i)) & 1
                                   : places.above[others * v + i - places.surfaces_in_bits];
                move_vertex(out, v, whole.positions[v],
                            field.frame.uvw(glm::dvec3(whole.positions[v])), field, sides, on);
            }
        });
}

// Returns the tolerance: flat triangles are to stay within the free room between walls and
// obstacles, if that is not much less than the tolerance asked for.
double tolerance_of(const SplitField& field, const SplitOptions& options)
{
    double free = options.tolerance;
    for (const Opening& o : field.openings)
        for (const OpeningWall& wall : o.walls) free = std::min(free, wall.clear);
    return std::max(free, options.tolerance / 4);
}

// A Parting holds the means to part a region of a mesh.
struct Parting {
    const SplitField& field;
    const SplitOptions& options;
    std::vector<Seam> seams; // of each opening; none unless it is to be stitched
    double tolerance;
    SplitError error;

    Parting(const Mesh& mesh, const SplitField& in_field, const SplitOptions& by)
        : field(in_field),
          options(by),
          seams(seams_of(mesh, field, options.closing)),
          tolerance(tolerance_of(field, options)),
          error(field, seams)
    {
    }
};

// Parts a mesh that is fine enough, all of its faces.
SplitMesh split_all(FineMesh fine, const Parting& parting)
{
    const auto& [field, options, seams, tolerance, error] = parting;
    SplitMesh out;
    out.off = fine.off;
    out.mesh = std::move(fine.mesh);
    out.first_new_face = out.mesh.face_count();
    const std::size_t openings = field.openings.size();
    VertexSides all{openings, {}, {}};
    all.resize(out.mesh.vertex_count());
    CutMesh before;
    for (std::size_t i = 0; i < openings; ++i) {
        add_heights(fine.heights, out.mesh, field);
        std::vector<double> heights(out.mesh.vertex_count());
        for (std::size_t v = 0; v < heights.size(); ++v)
            heights[v] = fine.heights[openings * v + i];
        // A cap of a later opening may run through the surface beside the walls, where it must be
        // cut
        const CutNeed need = need_of(out.mesh, field, i);
        CutMesh cut_mesh =
            cut(out.mesh, heights, std::move(before), i + 1 == openings ? &need : nullptr);
        const double moved = beside(cut_mesh, field, i);
        Caps caps;
        caps.first_vertex = cut_mesh.mesh.vertex_count();
        caps.first_face = cut_mesh.mesh.face_count();
        all.resize(cut_mesh.mesh.vertex_count());
        for (std::size_t v = 0; v < heights.size(); ++v) all.side(v, i) = cut_mesh.above[v];
        for (std::size_t e = 0; e < cut_mesh.edges.size(); ++e)
            for (const std::size_t above : {std::size_t{0}, std::size_t{1}})
                all.between(cut_mesh.first_vertex + 2 * e + above, cut_mesh.edges[e].x,
                            cut_mesh.edges[e].y, i, above == 1);
        if (options.closing != SplitClosing::open) {
            CapOptions closing = cap_options(field, i, cut_mesh, error,
                                             std::max(tolerance - moved, tolerance / 2), options);
            // The former positions of the vertices of the last cut are not read any more
            if (i + 1 == openings && options.closing == SplitClosing::capped)
                closing.meanwhile = [&] {
                    move(cut_mesh.mesh, out.rest_positions, field, seams, all);
                };
            caps = cap(cut_mesh, closing);
            all.resize(cut_mesh.mesh.vertex_count());
        }
        take_sides_of_caps(all, cut_mesh, caps, i);
        if (options.closing == SplitClosing::stitched) sew(cut_mesh, caps, field, i);
        out.off =
            std::max({out.off, fine.cut_error + moved, bound_of(cut_mesh, caps, error, i) + moved});
        out.fans += caps.fans;
        out.gaps += caps.gaps;
        if (options.closing != SplitClosing::stitched) out.open += caps.open;
        out.first_new_face = std::min(out.first_new_face, cut_mesh.first_new_face);
        std::swap(out.mesh, cut_mesh.mesh);
        before = std::move(cut_mesh);
    }
    if (options.closing == SplitClosing::stitched) leave_out_loose(out.mesh, all);
    move(out.mesh, out.rest_positions, field, seams, all);
    return out;
}

} // namespace

std::optional<SplitMesh> split(const Mesh& mesh, const SplitField& field,
                               const SplitOptions& options)
{
    SplitMemory none;
    return split(mesh, field, options, none);
}

std::optional<SplitMesh> split(const Mesh& mesh, const SplitField& field,
                               const SplitOptions& options, SplitMemory& memory)
{
    VertexPlaces& places = memory.places;
    find_places(mesh, field, places);
    if (places.box.apart(field.reach())) return std::nullopt;
    // Seams draw in all in reach, so all of it is tested with them
    const double enough =
        options.closing == SplitClosing::stitched ? -1 : tolerance_of(field, options);
    ToChange& change = memory.change;
    find_changes(mesh, places, field, SplitError(field), enough, change);
    if (change.faces.empty() && !change.moves) return std::nullopt;
    MeshRegion region = region_of(mesh, places.points, change.faces);
    std::vector<char> free;
    free.reserve(region.points.size());
    for (const std::uint32_t p : region.points) free.push_back(change.free[p]);

    const Parting parting(region.mesh, field, options);
    FineMesh fine = fine_enough(std::move(region.mesh), std::move(free), field, parting.error,
                                share_of_whole * parting.tolerance, options.most_triangles);

    // While the region is parted, the rest is copied and moved
    const std::size_t more_vertices =
        2 * (fine.mesh.vertex_count() - region.vertices.size()) + 4096;
    const std::size_t more_faces = fine.mesh.face_count() + 2 * more_vertices;
    SplitMesh out;
    Mesh whole = std::move(memory.mesh);
    std::vector<glm::vec3> rest;
    ArrayCopies both;
    both.add([&] { out = split_all(std::move(fine), parting); });
    both.add([&] {
        copy_others(whole, mesh, region.faces, more_vertices, more_faces);
        if (options.keep_rest) copy_with_room(mesh.positions, more_vertices, rest);
        move_others(whole, mesh, region, places, field);
    });
    both.run();
    put_back(whole, region, out.mesh);
    out.mesh = std::move(whole);
    out.off = std::max(out.off, change.off);
    out.first_new_face += mesh.face_count() - region.faces.size();
    const std::vector<glm::vec3> of_region = std::exchange(out.rest_positions, std::move(rest));
    if (options.keep_rest)
        out.rest_positions.insert(out.rest_positions.end(),
                                  of_region.begin() + static_cast<long>(region.vertices.size()),
                                  of_region.end());
    return out;
}

} // namespace trivar
