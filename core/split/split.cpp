// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split.h"

#include "core/base/parallel.h"
#include "core/split/cap.h"
#include "core/split/finer.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t vertices_per_block = 4096;

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

CapOptions cap_options(const SplitField& field, std::size_t opening, const CutMesh& cut,
                       const SplitError& error, const SplitOptions& options)
{
    const CutSurface& surface = field.openings[opening].surface;
    CapOptions out;
    for (const glm::vec3& place : cut.places)
        out.places.push_back(parameters_of(field.frame, place));
    out.point = [&](const glm::dvec2& vw) {
        return field.frame.world(glm::dvec3(evaluate(surface, vw).value, vw));
    };
    out.normal = [&](const glm::dvec2& vw) {
        const SurfaceJet<double> jet = evaluate(surface, vw, 1);
        return field.frame.axes * glm::normalize(glm::dvec3(1, -jet.u, -jet.v));
    };
    out.too_coarse = [&, opening](const std::array<glm::dvec2, 3>& vw) {
        return error.cap(opening, vw) > options.tolerance;
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

void move(SplitMesh& out, const SplitField& field, VertexSides& all)
{
    const Box reach = field.reach();
    out.rest_positions = out.mesh.positions;
    parallel_blocks(
        out.mesh.vertex_count(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const glm::dvec3 rest(out.rest_positions[v]);
                const glm::dvec3 uvw = field.frame.uvw(rest);
                if (glm::any(glm::lessThan(uvw, reach.lo)) ||
                    glm::any(glm::greaterThan(uvw, reach.hi)))
                    continue;
                const SplitField::Moved moved = field.moved(uvw, {&all.side(v, 0), all.openings},
                                                            {&all.is_on(v, 0), all.openings});
                if (moved.u == uvw.x && moved.gradient == glm::dvec3(1, 0, 0)) continue;
                out.mesh.positions[v] = glm::vec3(rest + field.frame.axes[0] * (moved.u - uvw.x));
                const auto mapped = [&](const glm::dvec3& direction) { // as a tangent is
                    glm::dvec3 d = glm::transpose(field.frame.axes) * direction;
                    d.x = glm::dot(moved.gradient, d);
                    return field.frame.axes * d;
                };
                if (!out.mesh.normals.empty()) {
                    // By the cofactors of the derivative, whose last two rows are those of the
                    // identity
                    const glm::dvec3 n =
                        glm::transpose(field.frame.axes) * glm::dvec3(out.mesh.normals[v]);
                    const glm::dvec3& g = moved.gradient;
                    out.mesh.normals[v] = glm::vec3(
                        field.frame.axes * glm::normalize(glm::dvec3(n.x, g.x * n.y - g.y * n.x,
                                                                     g.x * n.z - g.z * n.x)));
                }
                if (!out.mesh.tangents.empty()) {
                    const glm::dvec3 t = mapped(glm::dvec3(out.mesh.tangents[v]));
                    if (glm::length(t) > 0)
                        out.mesh.tangents[v] =
                            glm::vec4(glm::vec3(glm::normalize(t)), out.mesh.tangents[v].w);
                }
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
        most = std::max(most, error.cap(opening, vw));
    }
    return most;
}

} // namespace

std::optional<SplitMesh> split(const Mesh& mesh, const SplitField& field,
                               const SplitOptions& options)
{
    const Box reach = field.reach();
    Box box;
    for (const glm::vec3& p : mesh.positions) box.add(field.frame.uvw(glm::dvec3(p)));
    if (box.apart(reach)) return std::nullopt;

    const SplitError error(field);
    SplitMesh out;
    // An edge of the cut may be worse than the edges of the triangle that it runs through
    constexpr double share = 0.6;
    FineMesh fine =
        fine_enough(mesh, field, error, share * options.tolerance, options.most_triangles);
    out.off = fine.off;
    out.mesh = std::move(fine.mesh);
    out.first_new_face = out.mesh.face_count();
    const std::size_t openings = field.openings.size();
    VertexSides all{openings, {}, {}};
    all.resize(out.mesh.vertex_count());
    for (std::size_t i = 0; i < field.openings.size(); ++i) {
        add_heights(fine.heights, out.mesh, field);
        std::vector<double> heights(out.mesh.vertex_count());
        for (std::size_t v = 0; v < heights.size(); ++v)
            heights[v] = fine.heights[openings * v + i];
        CutMesh cut_mesh = cut(out.mesh, heights);
        Caps caps;
        caps.first_vertex = cut_mesh.mesh.vertex_count();
        caps.first_face = cut_mesh.mesh.face_count();
        if (options.capped) caps = cap(cut_mesh, cap_options(field, i, cut_mesh, error, options));
        all.resize(cut_mesh.mesh.vertex_count());
        for (std::size_t v = 0; v < heights.size(); ++v) all.side(v, i) = cut_mesh.above[v];
        for (std::size_t e = 0; e < cut_mesh.edges.size(); ++e)
            for (const std::size_t above : {std::size_t{0}, std::size_t{1}})
                all.between(cut_mesh.first_vertex + 2 * e + above, cut_mesh.edges[e].x,
                            cut_mesh.edges[e].y, i, above == 1);
        take_sides_of_caps(all, cut_mesh, caps, i);
        out.off = std::max(out.off, bound_of(cut_mesh, caps, error, i));
        out.fans += caps.fans;
        out.gaps += caps.gaps;
        out.open += caps.open;
        out.first_new_face = std::min(out.first_new_face, cut_mesh.first_new_face);
        out.mesh = std::move(cut_mesh.mesh);
    }
    move(out, field, all);
    return out;
}

} // namespace trivar
