// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/cut.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh_region.h"
#include "core/refinement/born_vertices.h"
#include "core/split/crossed_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t faces_per_cut_block = 1 << 15, vertices_per_sign_block = 1 << 16;

// The numbers of the faces whose corners are not all on one side, ascending.
std::vector<std::uint32_t> faces_across(const Mesh& mesh, const std::vector<char>& above)
{
    const std::size_t faces = mesh.face_count();
    std::vector<std::vector<std::uint32_t>> found(faces / faces_per_cut_block + 1);
    const bool triangles_only = mesh.corners.size() == 3 * faces;
    parallel_blocks(faces, faces_per_cut_block, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>& out = found[begin / faces_per_cut_block];
        if (triangles_only) {
            const std::uint32_t* c = mesh.corners.data() + 3 * begin;
            for (std::size_t f = begin; f < end; ++f, c += 3)
                if (above[c[0]] != above[c[1]] || above[c[0]] != above[c[2]])
                    out.push_back(static_cast<std::uint32_t>(f));
            return;
        }
        for (std::size_t f = begin; f < end; ++f) {
            const char first = above[mesh.corners[mesh.face_begin[f]]];
            for (std::uint32_t c = mesh.face_begin[f] + 1; c < mesh.face_begin[f + 1]; ++c)
                if (above[mesh.corners[c]] != first) {
                    out.push_back(static_cast<std::uint32_t>(f));
                    break;
                }
        }
    });
    std::vector<std::uint32_t> all;
    for (const std::vector<std::uint32_t>& each : found)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

struct CutTriangle {
    glm::uvec3 vertices;
    std::uint32_t face; // of the mesh that is cut
};

std::vector<CutTriangle> triangles_of(const Mesh& mesh, const std::vector<std::uint32_t>& faces)
{
    std::vector<CutTriangle> out;
    out.reserve(faces.size());
    Mesh one; // a face by itself, to be cut by ears
    for (const std::uint32_t f : faces) {
        const std::uint32_t* const c = mesh.corners.data() + mesh.face_begin[f];
        const std::uint32_t count = mesh.face_begin[f + 1] - mesh.face_begin[f];
        if (count == 3) {
            out.push_back({{c[0], c[1], c[2]}, f});
            continue;
        }
        one.positions.clear();
        one.corners.resize(count);
        std::iota(one.corners.begin(), one.corners.end(), 0u);
        one.face_begin = {0, count};
        for (std::uint32_t i = 0; i < count; ++i) one.positions.push_back(mesh.positions[c[i]]);
        for (const glm::uvec3& t : triangles(one)) out.push_back({{c[t.x], c[t.y], c[t.z]}, f});
    }
    return out;
}

// An edge that is cut, by its vertices; that with the smaller point is the first.
struct CutEdge {
    std::uint32_t a, b;
    bool operator==(const CutEdge&) const = default;
    auto operator<=>(const CutEdge&) const = default;
};

// Gives the edges that are cut their copies and places.
class Crossings {
public:
    // `both`: #V, or empty; see SidesOnCut
    Crossings(const Mesh& mesh, const std::vector<char>& above,
              const std::vector<CutTriangle>& across, const std::vector<char>& both = {})
        : mesh_(&mesh)
    {
        edges_.reserve(2 * across.size());
        for (const CutTriangle& t : across)
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = t.vertices[i], b = t.vertices[(i + 1) % 3];
                if (above[a] != above[b] && (both.empty() || !(both[a] || both[b])))
                    edges_.push_back(ordered(a, b));
            }
        for (std::uint32_t v = 0; v < both.size(); ++v)
            if (both[v]) edges_.push_back({v, v});
        std::ranges::sort(edges_);
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
        for (const CutEdge& e : edges_) places_.push_back(by_points(e));
        std::ranges::sort(places_);
        places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    }
    const std::vector<CutEdge>& edges() const { return edges_; }
    std::size_t place_count() const { return places_.size(); }
    std::uint32_t edge(std::uint32_t a, std::uint32_t b) const
    {
        return index_of(edges_, ordered(a, b));
    }
    std::uint32_t place(const CutEdge& edge) const { return index_of(places_, by_points(edge)); }
    std::uint32_t place(std::uint32_t a, std::uint32_t b) const { return place(ordered(a, b)); }

private:
    CutEdge ordered(std::uint32_t a, std::uint32_t b) const
    {
        return mesh_->point(a) < mesh_->point(b) ? CutEdge{a, b} : CutEdge{b, a};
    }
    CutEdge by_points(const CutEdge& e) const { return {mesh_->point(e.a), mesh_->point(e.b)}; }
    static std::uint32_t index_of(const std::vector<CutEdge>& sorted, const CutEdge& edge)
    {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, edge) - sorted.begin());
    }

    const Mesh* mesh_;
    std::vector<CutEdge> edges_, places_; // places: edges between points
};

// Whether all loops of the cut are closed: each place is passed as often as left.
bool all_closed(const std::vector<CutTriangle>& across, const std::vector<char>& above,
                const Crossings& crossings)
{
    std::vector<char> odd(crossings.place_count(), 0);
    for (const CutTriangle& t : across)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t.vertices[i], b = t.vertices[(i + 1) % 3];
            if (above[a] != above[b]) odd[crossings.place(a, b)] ^= 1;
        }
    return std::ranges::find(odd, 1) == odd.end();
}

// Takes out the triangles that need not be cut. Where a loop is open, so that a cap may go across a
// gap, all are cut. Returns whether there were any.
bool leave_whole(std::vector<CutTriangle>& across, const Mesh& mesh, const std::vector<char>& above,
                 const Crossings& crossings, const CutNeed& need)
{
    std::vector<glm::uvec3> vertices;
    vertices.reserve(across.size());
    for (const CutTriangle& t : across) vertices.push_back(t.vertices);
    const std::vector<char> cut = needed(vertices, mesh, need);
    if (cut.empty() || !all_closed(across, above, crossings)) return false;
    std::size_t to = 0;
    for (std::size_t k = 0; k < across.size(); ++k)
        if (cut[k]) across[to++] = across[k];
    across.resize(to);
    return true;
}

// An edge from one place on the cut to another of a face on one side.
struct EdgeOnCut {
    std::uint32_t from, to;
    bool up;
};

// The faces that a triangle across the cut becomes: one on the side of its single corner, two on
// the other side. One of each where a corner lies on the cut.
class FaceMaker {
public:
    FaceMaker(CutMesh& out, const Mesh& mesh, const Crossings& crossings,
              const std::vector<std::uint32_t>& place_of_edge, const std::vector<char>& both)
        : out_(out),
          mesh_(mesh),
          crossings_(crossings),
          place_of_edge_(place_of_edge),
          both_(both)
    {
    }
    void operator()(const CutTriangle& t)
    {
        if (const int lying = both(t, 0) + both(t, 1) + both(t, 2); lying > 0) {
            bool up = true; // where all of it lies on the cut
            for (int i = 0; i < 3; ++i) {
                if (lying == 1 && both(t, i) && above(t, i + 1) != above(t, i + 2))
                    return cut_at_corner(t, i);
                if (!both(t, i)) up = above(t, i);
            }
            return whole(t.face, corners(t), up);
        }
        if (above(t, 0) == above(t, 1) && above(t, 0) == above(t, 2)) { // of a larger face
            add(t.face, corners(t));
            return;
        }
        int lone = 0; // the corner that is alone on its side
        for (int i = 0; i < 3; ++i)
            if (above(t, i) != above(t, i + 1) && above(t, i) != above(t, i + 2)) lone = i;
        const std::uint32_t x = corner(t, lone), y = corner(t, lone + 1), z = corner(t, lone + 2);
        const bool up = out_.above[x];
        const std::uint32_t xy = crossings_.edge(x, y), xz = crossings_.edge(x, z);
        add(t.face, std::array{x, copy(xy, up), copy(xz, up)});
        // The shorter diagonal of the rest
        const glm::dvec3 p(out_.mesh.positions[copy(xy, !up)]);
        const glm::dvec3 q(out_.mesh.positions[copy(xz, !up)]);
        if (glm::distance(p, glm::dvec3(mesh_.positions[z])) <
            glm::distance(q, glm::dvec3(mesh_.positions[y]))) {
            add(t.face, std::array{copy(xy, !up), y, z});
            add(t.face, std::array{copy(xy, !up), z, copy(xz, !up)});
        } else {
            add(t.face, std::array{copy(xy, !up), y, copy(xz, !up)});
            add(t.face, std::array{y, z, copy(xz, !up)});
        }
        const std::uint32_t from = place_of_edge_[xy], to = place_of_edge_[xz];
        out_.rim.push_back(up ? glm::uvec2(from, to) : glm::uvec2(to, from));
    }
    // A face that is all on one side, with copies of its corners on the cut.
    void whole(std::uint32_t face, std::span<const std::uint32_t> vertices, bool up)
    {
        std::vector<std::uint32_t> own(vertices.begin(), vertices.end());
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::uint32_t v = vertices[i], next = vertices[(i + 1) % own.size()];
            if (!both_[v]) continue;
            own[i] = copy(crossings_.edge(v, v), up);
            if (both_[next]) edges_.push_back({place_of(v), place_of(next), up});
        }
        add(face, own);
    }
    // The rim along edges of the mesh, after all faces: where one above has one below beside it.
    void add_rim()
    {
        const auto ends = [](const EdgeOnCut& e) { return std::minmax(e.from, e.to); };
        std::ranges::sort(edges_, {}, ends);
        for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
            const auto [lo, hi] = ends(edges_[begin]);
            std::array<int, 2> rising{}; // how many more run from lo to hi: below, above
            for (; end < edges_.size() && ends(edges_[end]) == ends(edges_[begin]); ++end)
                rising[edges_[end].up ? 1 : 0] += edges_[end].from == lo ? 1 : -1;
            for (; rising[1] > 0 && rising[0] < 0; --rising[1], ++rising[0])
                out_.rim.emplace_back(lo, hi);
            for (; rising[1] < 0 && rising[0] > 0; ++rising[1], --rising[0])
                out_.rim.emplace_back(hi, lo);
        }
    }

private:
    // A triangle between its corner i, which lies on the cut, and a place on the other edge.
    void cut_at_corner(const CutTriangle& t, int i)
    {
        const std::uint32_t on = corner(t, i), y = corner(t, i + 1), z = corner(t, i + 2);
        const std::uint32_t at = crossings_.edge(on, on), yz = crossings_.edge(y, z);
        const bool up = out_.above[y];
        add(t.face, std::array{copy(at, up), y, copy(yz, up)});
        add(t.face, std::array{copy(at, !up), copy(yz, !up), z});
        const std::uint32_t from = place_of_edge_[yz], to = place_of_edge_[at];
        out_.rim.push_back(up ? glm::uvec2(from, to) : glm::uvec2(to, from));
    }
    static std::uint32_t corner(const CutTriangle& t, int i) { return t.vertices[i % 3]; }
    static std::array<std::uint32_t, 3> corners(const CutTriangle& t)
    {
        return {t.vertices.x, t.vertices.y, t.vertices.z};
    }
    bool above(const CutTriangle& t, int i) const { return out_.above[corner(t, i)]; }
    bool both(const CutTriangle& t, int i) const { return !both_.empty() && both_[corner(t, i)]; }
    std::uint32_t place_of(std::uint32_t v) const { return place_of_edge_[crossings_.edge(v, v)]; }
    std::uint32_t copy(std::uint32_t edge, bool up) const
    {
        return out_.first_vertex + 2 * edge + (up ? 1 : 0);
    }
    void add(std::uint32_t face, std::span<const std::uint32_t> vertices)
    {
        add_face(out_.mesh, vertices);
        if (!mesh_.face_material.empty())
            out_.mesh.face_material.push_back(mesh_.face_material[face]);
        if (!mesh_.face_group.empty()) out_.mesh.face_group.push_back(mesh_.face_group[face]);
    }

    CutMesh& out_;
    const Mesh& mesh_;
    const Crossings& crossings_;
    const std::vector<std::uint32_t>& place_of_edge_;
    const std::vector<char>& both_;
    std::vector<EdgeOnCut> edges_;
};

} // namespace

CutMesh cut(const Mesh& mesh, std::span<const double> heights, CutMesh memory, const CutNeed* need,
            const OnCut* on)
{
    ensure(heights.size() == mesh.vertex_count(), "heights are not of this mesh");
    CutMesh out;
    out.mesh = std::move(memory.mesh);
    out.above = std::move(memory.above);
    out.above.resize(heights.size());
    parallel_blocks(heights.size(), vertices_per_sign_block,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t v = begin; v < end; ++v) out.above[v] = heights[v] >= 0;
                    });
    const bool lies =
        on && std::ranges::any_of(heights, [&](double h) { return std::abs(h) <= on->within; });
    const SidesOnCut lying = lies ? sides_on_cut(mesh, heights, *on) : SidesOnCut{};
    if (lies) out.above = lying.above;
    std::vector<std::uint32_t> faces = lies ? lying.across : faces_across(mesh, out.above);
    std::vector<CutTriangle> across = triangles_of(mesh, faces);
    Crossings crossings(mesh, out.above, across, lying.both);
    if (need && leave_whole(across, mesh, out.above, crossings, *need)) {
        faces.clear();
        for (const CutTriangle& t : across) faces.push_back(t.face);
        crossings = Crossings(mesh, out.above, across, lying.both);
    }
    faces.insert(faces.end(), lying.beside.begin(), lying.beside.end());
    std::ranges::sort(faces);
    out.first_new_face = mesh.face_count() - faces.size();
    if (faces.empty()) {
        out.mesh = mesh;
        return out;
    }

    // Copies on both halves, and the rims of both caps
    const std::size_t more = 5 * crossings.edges().size() + 64;
    copy_others(out.mesh, mesh, faces, more, 2 * more);
    out.first_vertex = static_cast<std::uint32_t>(mesh.vertex_count());
    out.first_point =
        static_cast<std::uint32_t>(mesh.points.empty() ? mesh.vertex_count() : point_count(mesh));
    std::vector<BornVertex> born;
    born.reserve(2 * crossings.edges().size());
    std::vector<CrossedEdge> crossed;
    crossed.reserve(crossings.edges().size());
    for (const CutEdge& e : crossings.edges())
        crossed.push_back({{mesh.point(e.a), mesh.point(e.b)}, {heights[e.a], heights[e.b]}});
    if (!on) move_apart(crossed);
    out.moved.resize(crossings.place_count());
    std::vector<std::uint32_t> place_of_edge;
    out.edge_of_place.resize(crossings.place_count());
    for (const CutEdge& e : crossings.edges()) {
        const auto& [a, b] = crossed[out.edges.size()].heights;
        const auto t = e.a == e.b ? 0 : static_cast<float>(a / (a - b));
        place_of_edge.push_back(crossings.place(e));
        out.moved[place_of_edge.back()] =
            std::max(std::abs(a - heights[e.a]), std::abs(b - heights[e.b]));
        out.edge_of_place[place_of_edge.back()] = static_cast<std::uint32_t>(out.edges.size());
        out.edges.emplace_back(e.a, e.b);
        for (const bool up : {false, true}) {
            born.push_back({e.a, e.b, t, out.point(place_of_edge.back(), up)});
            out.above.push_back(up);
        }
    }
    add_vertices(out.mesh, born);
    out.places.resize(crossings.place_count());
    for (std::size_t e = 0; e < place_of_edge.size(); ++e)
        out.places[place_of_edge[e]] = out.mesh.positions[out.first_vertex + 2 * e];

    FaceMaker make(out, mesh, crossings, place_of_edge, lying.both);
    for (const CutTriangle& t : across) make(t);
    for (const std::uint32_t f : lying.beside)
        make.whole(f,
                   {mesh.corners.data() + mesh.face_begin[f],
                    mesh.corners.data() + mesh.face_begin[f + 1]},
                   lying.sides[f] == side_above);
    make.add_rim();
    return out;
}

} // namespace trivar
