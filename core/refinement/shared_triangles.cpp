// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/shared_triangles.h"

#include "core/base/parallel.h"
#include "core/ffd/deform.h"
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace trivar {

SharedTriangles::SharedTriangles(const std::vector<RefinePart>& parts, const Lattice& lattice,
                                 const std::vector<NextVolume>& next)
    : given_(parts),
      lattice_(lattice),
      next_(next),
      parts_(parts.size())
{
    take_vertices();
    take_triangles();
}

void SharedTriangles::take_vertices()
{
    struct VertexPlace {
        glm::dvec3 uvw;
        Index part, vertex;
    };
    std::vector<VertexPlace> placed;
    for (std::size_t p = 0; p < given_.size(); ++p) {
        parts_[p].mesh = *given_[p].mesh;
        parts_[p].next_surface_point = static_cast<Index>(point_count(*given_[p].mesh));
        const std::vector<glm::vec3>& positions = given_[p].mesh->positions;
        parts_[p].point_of.resize(positions.size());
        for (std::size_t v = 0; v < positions.size(); ++v)
            // + 0.0 turns -0 into 0
            placed.push_back(
                {glm::dvec3(given_[p].embedding.to_uvw * glm::dvec4(positions[v], 1)) + 0.0,
                 static_cast<Index>(p), static_cast<Index>(v)});
    }
    std::ranges::sort(placed, [](const VertexPlace& x, const VertexPlace& y) {
        return std::tie(x.uvw.x, x.uvw.y, x.uvw.z, x.part, x.vertex) <
               std::tie(y.uvw.x, y.uvw.y, y.uvw.z, y.part, y.vertex);
    });
    std::vector<std::size_t> first; // by point
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (i == 0 || placed[i].uvw != placed[i - 1].uvw) first.push_back(i);
        parts_[placed[i].part].point_of[placed[i].vertex] = static_cast<Index>(first.size() - 1);
    }
    points_.resize(first.size());
    parallel_blocks(first.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const VertexPlace& from = placed[first[i]];
            place(points_[i], given_[from.part].embedding,
                  given_[from.part].mesh->positions[from.vertex]);
        }
    });
    for (std::size_t p = 0; p < given_.size(); ++p) measure_places(p, 0);
}

void SharedTriangles::place(Point& point, const Embedding& embedding,
                            const glm::dvec3& p_object) const
{
    const glm::dvec4 p(p_object, 1);
    point.uvw = glm::dvec3(embedding.to_uvw * p) + 0.0; // + 0.0 turns -0 into 0
    point.displacement = evaluate(lattice_.displacement, point.uvw).value;
    point.rest_world = glm::dvec3(embedding.to_rest * p);
    point.last_world = through(next_, point.first_world());
}

// Deforms new vertices with the same bits as later in the whole mesh.
void SharedTriangles::measure_places(std::size_t p, std::size_t first)
{
    const State& part = parts_[p];
    const Embedding& embedding = given_[p].embedding;
    Mesh fresh;
    fresh.positions.assign(part.mesh.positions.begin() + static_cast<std::ptrdiff_t>(first),
                           part.mesh.positions.end());
    if (fresh.positions.empty()) return;
    Mesh placed = deform(fresh, embedding, lattice_);
    for (const NextVolume& next : next_) placed = deform(placed, next.embedding, *next.lattice);
    for (std::size_t v = 0; v < fresh.positions.size(); ++v) {
        Point& point = points_[part.point_of[first + v]];
        // The vertices of a point may be in several parts and differ at rest by rounding.
        const glm::dvec3 rest(embedding.to_rest * glm::dvec4(fresh.positions[v], 1));
        const glm::dvec3 wanted = through(next_, rest + point.displacement);
        const double off = glm::distance(glm::dvec3(placed.positions[v]), wanted);
        if (!(off <= point.misplaced))
            point.misplaced = std::isfinite(off) ? off : std::numeric_limits<double>::infinity();
    }
}

void SharedTriangles::take_triangles()
{
    std::vector<Index> corners; // of all triangles, sorted by point
    for (std::size_t p = 0; p < given_.size(); ++p) {
        const Mesh& mesh = *given_[p].mesh;
        const std::vector<glm::uvec3> cut = trivar::triangles(mesh);
        triangles_before_.push_back(cut.size());
        std::size_t face = 0;
        for (std::size_t t = 0; t < cut.size(); ++t) {
            while (t + 2 * (face + 1) >= mesh.face_begin[face + 1]) ++face;
            Triangle& made = triangles_.emplace_back();
            made.part = static_cast<Index>(p);
            made.face = static_cast<Index>(face);
            for (std::size_t i = 0; i < 3; ++i) made.vertices[i] = cut[t][static_cast<int>(i)];
            for (const Index vertex : made.vertices) corners.push_back(parts_[p].point_of[vertex]);
        }
    }
    const Adjacency adjacency(std::move(corners), points_.size());
    for (const glm::uvec2& ends : adjacency.edges()) edges_.push_back({.a = ends.x, .b = ends.y});
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            triangles_[t].edges[i] = adjacency.edge_at(static_cast<Index>(3 * t + i));
}

ComposedBounds::Simplex<3> SharedTriangles::simplex(const Triangle& triangle) const
{
    ComposedBounds::Simplex<3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Index point = parts_[triangle.part].point_of[triangle.vertices[i]];
        out.by_first[i] = corner(point);
        out.world[i] = points_[point].first_world();
    }
    return out;
}

double SharedTriangles::length_world(const Edge& edge) const
{
    return glm::distance(points_[edge.a].last_world, points_[edge.b].last_world);
}

double SharedTriangles::middle_off(const Edge& edge) const
{
    const Point &a = points_[edge.a], &b = points_[edge.b];
    const glm::dvec3 rest = (a.rest_world + b.rest_world) / 2.0,
                     moved = evaluate(lattice_.displacement, (a.uvw + b.uvw) / 2.0).value;
    if (next_.empty()) return glm::distance(moved, (a.displacement + b.displacement) / 2.0);
    return glm::distance(through(next_, rest + moved), (a.last_world + b.last_world) / 2.0);
}

SharedTriangles::Index SharedTriangles::add_edge(Index p, Index q)
{
    const auto key = [&](Index i) {
        const glm::dvec3& at = points_[i].uvw;
        return std::tuple(at.x, at.y, at.z, i);
    };
    if (key(q) < key(p)) std::swap(p, q);
    edges_.push_back({.a = p, .b = q});
    return static_cast<Index>(edges_.size() - 1);
}

SharedTriangles::Index SharedTriangles::vertex_on(Index e, Index part, Index va, Index vb)
{
    State& of = parts_[part];
    if (of.point_of[va] != edges_[e].a) std::swap(va, vb);
    const auto point = [&](Index v) { return of.mesh.point(v); };
    Index surface_point = none;
    for (Index i = edges_[e].first_twin; i != none; i = twins_[i].next) {
        const Twin& twin = twins_[i];
        if (twin.part != part) continue;
        if (twin.a == va && twin.b == vb) return twin.born;
        if (!of.mesh.points.empty() && point(twin.a) == point(va) && point(twin.b) == point(vb))
            surface_point = twin.surface_point;
    }
    if (surface_point == none) surface_point = of.next_surface_point++;
    const auto born = static_cast<Index>(of.mesh.vertex_count() + of.born.size());
    of.born.push_back({va, vb, edges_[e].t, surface_point});
    of.point_of.push_back(edges_[e].middle);
    twins_.push_back({part, va, vb, born, surface_point, edges_[e].first_twin});
    edges_[e].first_twin = static_cast<Index>(twins_.size() - 1);
    return born;
}

void SharedTriangles::split_marked()
{
    const std::size_t first_point = points_.size(), known = edges_.size();
    twins_.clear();
    for (std::size_t e = 0; e < known; ++e) {
        if (!edges_[e].marked) continue;
        const auto middle = static_cast<Index>(points_.size());
        Point point;
        point.depth = std::max(points_[edges_[e].a].depth, points_[edges_[e].b].depth) + 1;
        points_.push_back(point);
        edges_[e].middle = middle;
        edges_[e].halves = static_cast<Index>(edges_.size());
        edges_.push_back({.a = edges_[e].a, .b = middle});
        edges_.push_back({.a = middle, .b = edges_[e].b});
    }
    struct Maker {
        Index part = none, vertex = 0;
    };
    std::vector<Maker> makers(points_.size() - first_point);
    for (const Triangle& t : triangles_)
        for (std::size_t i = 0; i < 3; ++i) {
            const Edge& edge = edges_[t.edges[i]];
            if (!edge.marked) continue;
            Maker& maker = makers[edge.middle - first_point];
            const Index born =
                vertex_on(t.edges[i], t.part, t.vertices[i], t.vertices[(i + 1) % 3]);
            if (maker.part == none) maker = {t.part, born};
        }
    for (State& part : parts_) {
        part.split |= !part.born.empty();
        add_vertices(part.mesh, part.born);
    }
    parallel_blocks(makers.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Maker& maker = makers[i];
            const Embedding& embedding = given_[maker.part].embedding;
            const State& part = parts_[maker.part];
            const std::vector<glm::vec3>& positions = part.mesh.positions;
            const BornVertex& born =
                part.born[maker.vertex - (positions.size() - part.born.size())];
            const glm::dvec3 rounded(positions[maker.vertex]),
                exact = glm::mix(glm::dvec3(positions[born.a]), glm::dvec3(positions[born.b]),
                                 double{born.t});
            Point& point = points_[first_point + i];
            point.moved = glm::mix(points_[part.point_of[born.a]].moved,
                                   points_[part.point_of[born.b]].moved, double{born.t}) +
                          glm::distance(rounded, exact);
            place(point, embedding, rounded);
        }
    });
    for (std::size_t p = 0; p < parts_.size(); ++p)
        measure_places(p, parts_[p].mesh.vertex_count() - parts_[p].born.size());
    std::vector<Triangle> out;
    out.reserve(triangles_.size() + 2 * makers.size());
    for (const Triangle& t : triangles_) split_triangle(t, out);
    triangles_ = std::move(out);
    for (std::size_t e = 0; e < known; ++e) edges_[e].marked = false;
    for (State& part : parts_) {
        part.all_born.insert(part.all_born.end(), part.born.begin(), part.born.end());
        part.born.clear();
    }
}

void SharedTriangles::split_triangle(const Triangle& t, std::vector<Triangle>& out)
{
    std::array<Index, 3> middle{none, none, none};
    int marked = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (edges_[t.edges[i]].marked) {
            middle[i] = vertex_on(t.edges[i], t.part, t.vertices[i], t.vertices[(i + 1) % 3]);
            ++marked;
        }
    if (marked == 0) {
        out.push_back(t);
        return;
    }
    const std::vector<Index>& point_of = parts_[t.part].point_of;
    const auto add = [&](std::array<Index, 3> vertices, std::array<Index, 3> edges) {
        out.push_back({vertices, edges, t.part, t.face, unknown});
    };
    const auto half = [&](std::size_t i, Index vertex) { // half of edge i at one of its ends
        const Edge& edge = edges_[t.edges[i]];
        return point_of[vertex] == edge.a ? edge.halves : edge.halves + 1;
    };
    const auto across = [&](Index x, Index y) { return add_edge(point_of[x], point_of[y]); };
    if (marked == 3) {
        const auto [a, b, c] = t.vertices;
        const auto [x, y, z] = middle;
        const Index xz = across(x, z), yx = across(y, x), zy = across(z, y);
        add({a, x, z}, {half(0, a), xz, half(2, a)});
        add({x, b, y}, {half(0, b), half(1, b), yx});
        add({z, y, c}, {zy, half(1, c), half(2, c)});
        add({x, y, z}, {yx, zy, xz});
        return;
    }
    // Rotates the triangle so that its first edge is the only marked one, or the only unmarked one.
    std::size_t i = 0;
    while ((middle[i] != none) != (marked == 1)) ++i;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Index p = t.vertices[i], q = t.vertices[j], r = t.vertices[k];
    if (marked == 1) {
        const Index x = middle[i], xr = across(x, r);
        add({p, x, r}, {half(i, p), xr, t.edges[k]});
        add({x, q, r}, {half(i, q), t.edges[j], xr});
        return;
    }
    const Index x = middle[j], y = middle[k], yx = across(y, x);
    const auto apart = [&](Index v, Index w) {
        return length_world({.a = point_of[v], .b = point_of[w]});
    };
    add({y, x, r}, {yx, half(j, r), half(k, r)});
    if (apart(p, x) < apart(q, y)) {
        const Index px = across(p, x);
        add({p, q, x}, {t.edges[i], half(j, q), px});
        add({p, x, y}, {px, yx, half(k, p)});
    } else {
        const Index qy = across(q, y);
        add({p, q, y}, {t.edges[i], qy, half(k, p)});
        add({q, x, y}, {half(j, q), yx, qy});
    }
}

Ref<Mesh> SharedTriangles::mesh(std::size_t p) const
{
    const Mesh& before = *given_[p].mesh;
    if (!parts_[p].split && triangles_before_[p] == before.face_count()) return given_[p].mesh;
    Mesh mesh = parts_[p].mesh;
    mesh.corners.clear();
    mesh.face_begin = {0};
    mesh.face_group.clear();
    mesh.face_material.clear();
    if (parts_[p].split) mesh.creases.clear(); // creases are for subdivision, which is done
    for (const Triangle& t : triangles_) {
        if (t.part != p) continue;
        add_face(mesh, t.vertices);
        if (!before.face_group.empty()) mesh.face_group.push_back(before.face_group[t.face]);
        if (!before.face_material.empty())
            mesh.face_material.push_back(before.face_material[t.face]);
    }
    return make_ref(std::move(mesh));
}

} // namespace trivar
