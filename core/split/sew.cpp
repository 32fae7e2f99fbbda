// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/sew.h"

#include "core/base/joined_sets.h"

#include <algorithm>

namespace trivar {
namespace {

// Leaves out faces from `first` on.
void leave_out(Mesh& mesh, std::size_t first, const std::vector<char>& left_out)
{
    std::size_t to = first, corner = mesh.face_begin[first];
    for (std::size_t f = first; f < mesh.face_count(); ++f) {
        if (left_out[f - first]) continue;
        const std::size_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::size_t c = begin; c < end; ++c) mesh.corners[corner++] = mesh.corners[c];
        if (!mesh.face_material.empty()) mesh.face_material[to] = mesh.face_material[f];
        if (!mesh.face_group.empty()) mesh.face_group[to] = mesh.face_group[f];
        mesh.face_begin[++to] = static_cast<std::uint32_t>(corner);
    }
    mesh.corners.resize(corner);
    mesh.face_begin.resize(to + 1);
    if (!mesh.face_material.empty()) mesh.face_material.resize(to);
    if (!mesh.face_group.empty()) mesh.face_group.resize(to);
}

// The relation of the two copies of a vertex of a cap.
enum class Half : char { apart, joined, hidden };

using CapTriangle = std::array<std::size_t, 3>;

bool stays(const CapTriangle& t, const std::vector<Half>& halves)
{
    return std::ranges::any_of(t, [&](std::size_t c) { return halves[c] == Half::apart; });
}

// Hides caps round an opening of its own that does not reach the rim.
void hide_what_is_inside(const std::vector<CapTriangle>& triangles, std::size_t places,
                         std::vector<Half>& halves)
{
    JoinedSets groups(halves.size());
    for (const CapTriangle& t : triangles) {
        std::optional<std::uint32_t> last; // of its corners that are apart
        for (const std::size_t c : t) {
            if (halves[c] != Half::apart) continue;
            const auto corner = static_cast<std::uint32_t>(c);
            if (last) groups.join(corner, *last);
            last = corner;
        }
    }
    std::vector<char> at_rim(halves.size(), 0);
    for (std::uint32_t i = 0; i < places; ++i)
        if (halves[i] == Half::apart) at_rim[groups.root(i)] = 1;
    for (std::uint32_t i = 0; i < halves.size(); ++i)
        if (halves[i] == Half::apart && !at_rim[groups.root(i)]) halves[i] = Half::hidden;
}

// Takes vertices apart that are among triangles which stay: an edge between two joined vertices is
// to be on one such triangle of each half, at the end of the caps that stay, or it would be on four
// faces.
void keep_edges_apart(const std::vector<CapTriangle>& triangles, const std::vector<glm::uvec2>& rim,
                      std::vector<Half>& halves)
{
    constexpr int most_rounds_apart = 8;
    using Edge = std::pair<std::size_t, std::size_t>;
    for (int round = 0; round < most_rounds_apart; ++round) {
        // 1: some triangle at it is left out; 2: some stays
        std::vector<char> at(halves.size(), 0);
        for (const CapTriangle& t : triangles)
            for (const std::size_t c : t) at[c] |= stays(t, halves) ? 2 : 1;
        for (std::size_t i = 0; i < halves.size(); ++i)
            if (halves[i] == Half::joined && at[i] == 2) halves[i] = Half::apart;
        std::vector<Edge> edges;
        const auto add = [&](std::size_t a, std::size_t b) {
            if (halves[a] == Half::joined && halves[b] == Half::joined)
                edges.push_back(std::minmax(a, b));
        };
        for (const CapTriangle& t : triangles)
            if (stays(t, halves))
                for (std::size_t i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3]);
        if (edges.empty()) return;
        for (const glm::uvec2& edge : rim)
            if ((at[edge.x] | at[edge.y]) & 2) add(edge.x, edge.y);
        std::ranges::sort(edges);
        bool changed = false;
        for (std::size_t i = 1; i < edges.size(); ++i) {
            if (edges[i] != edges[i - 1] || halves[edges[i].first] != Half::joined ||
                halves[edges[i].second] != Half::joined)
                continue;
            halves[edges[i].first] = Half::apart;
            changed = true;
        }
        if (!changed) return;
    }
}

// Makes copies that are joined one point.
void join_points(CutMesh& cut, const std::vector<Half>& halves)
{
    const std::size_t places = cut.places.size(), inside = halves.size() - places;
    for (std::size_t v = cut.first_vertex; v < cut.mesh.vertex_count(); ++v) {
        std::uint32_t& point = cut.mesh.points[v];
        const std::size_t p = point - cut.first_point;
        if (p < 2 * places) {
            if (halves[p / 2] == Half::joined)
                point = cut.point(static_cast<std::uint32_t>(p / 2), false);
        } else if (p >= 2 * places + inside && halves[p - places - inside] == Half::joined)
            point -= static_cast<std::uint32_t>(inside);
    }
}

} // namespace

void sew(CutMesh& cut, const Caps& caps, const SplitField& field, std::size_t opening)
{
    if (cut.rim.empty()) return;
    Mesh& mesh = cut.mesh;
    const std::size_t places = cut.places.size();
    // Vertices of one half's cap: first the places, then points inside
    const std::size_t count = std::max(places, caps.parameters.size() / 2);
    std::vector<Half> joined(count, Half::apart);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 uvw =
            field.frame.uvw(i < places ? glm::dvec3(cut.places[i]) : glm::dvec3(0));
        if (field.openings[opening].beyond_walls(i < places ? glm::dvec2(uvw.y, uvw.z)
                                                            : caps.parameters[i]))
            joined[i] = Half::joined;
    }
    const std::size_t faces = (mesh.face_count() - caps.first_face) / 2; // of one half
    const auto corners = [&](std::size_t f) {
        std::array<std::size_t, 3> out;
        for (std::size_t i = 0; i < 3; ++i)
            out[i] = mesh.corners[mesh.face_begin[caps.first_face + f] + i] - caps.first_vertex;
        return out;
    };
    std::vector<std::array<std::size_t, 3>> triangles(faces);
    for (std::size_t f = 0; f < faces; ++f) triangles[f] = corners(f);
    hide_what_is_inside(triangles, places, joined);
    keep_edges_apart(triangles, cut.rim, joined);
    join_points(cut, joined);
    std::vector<char> left_out(2 * faces, 0);
    for (std::size_t f = 0; f < faces; ++f)
        left_out[f] = left_out[faces + f] = !stays(triangles[f], joined);
    leave_out(mesh, caps.first_face, left_out);
}

std::array<double, 3> reach_beyond(const std::array<glm::dvec2, 3>& vw, const Opening& opening)
{
    constexpr double most = 1.0 / 24; // of the opening's length
    const double length = opening.walls[0].hi().x - opening.walls[0].lo().x;
    std::array<double, 3> out{};
    int beyond = 0;
    for (const glm::dvec2& corner : vw) beyond += opening.beyond_walls(corner);
    if (beyond == 0 || beyond == 3) return out;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = glm::distance(vw[i], vw[(i + 1) % 3]) / (most * length);
    return out;
}

void move_sewn(Mesh& mesh, std::size_t vertex, const SplitField& field, std::span<const Seam> seams,
               std::span<const char> sides, std::span<const char> on)
{
    const glm::dmat3& axes = field.frame.axes;
    const glm::dvec3 rest(mesh.positions[vertex]);
    const glm::dvec3 uvw = field.frame.uvw(rest);
    const DrawnIn drawn = drawn_in(field, seams, uvw, sides, on);
    const SplitField::Moved moved = field.moved(drawn.uvw, sides, on);
    const glm::dvec3& g = moved.gradient;
    const glm::dvec3 u = g.x * drawn.u + glm::dvec3(0, g.y, 0) + g.z * drawn.w;
    const glm::dvec3 v(0, 1, 0), &w = drawn.w;
    if (moved.u == uvw.x && drawn.uvw.z == uvw.z && u == glm::dvec3(1, 0, 0) &&
        w == glm::dvec3(0, 0, 1))
        return;
    mesh.positions[vertex] =
        glm::vec3(rest + axes[0] * (moved.u - uvw.x) + axes[2] * (drawn.uvw.z - uvw.z));
    const auto put = [&](glm::vec3& unit, const glm::dvec3& own) {
        const glm::dvec3 world = axes * own;
        if (glm::length(world) > 0) unit = glm::vec3(glm::normalize(world));
    };
    if (!mesh.normals.empty()) { // by the cofactors of the derivative, whose rows are u, v and w
        const glm::dvec3 n = glm::transpose(axes) * glm::dvec3(mesh.normals[vertex]);
        put(mesh.normals[vertex], {glm::dot(glm::cross(v, w), n), glm::dot(glm::cross(w, u), n),
                                   glm::dot(glm::cross(u, v), n)});
    }
    if (!mesh.tangents.empty()) {
        const glm::dvec3 t = glm::transpose(axes) * glm::dvec3(glm::vec3(mesh.tangents[vertex]));
        glm::vec3 unit(mesh.tangents[vertex]);
        put(unit, {glm::dot(u, t), t.y, glm::dot(w, t)});
        mesh.tangents[vertex] = glm::vec4(unit, mesh.tangents[vertex].w);
    }
}

} // namespace trivar
