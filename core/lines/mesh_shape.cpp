// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/mesh_shape.h"

#include "core/base/joined_sets.h"
#include "core/base/key_numbers.h"
#include "core/base/parallel.h"
#include "core/lines/zero_lines.h"
#include "core/mesh/adjacency.h"
#include "core/silhouette/edge_chains.h"
#include "core/silhouette/silhouette_curves.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float goes_with_faces = 0.9f; // cosine between a normal of a mesh and those of its faces
constexpr float goes_on = 0.5f;         // cosine between edges that are one line

// The triangles of a mesh between points, none twice and none a line, with what they came from.
struct PointTriangles {
    std::vector<std::uint32_t> corners;  // points
    std::vector<std::uint32_t> vertices; // of the mesh
};

PointTriangles point_triangles(const Mesh& mesh, std::span<const std::uint32_t> point_of)
{
    const std::vector<glm::uvec3> all = triangles(mesh);
    std::vector<std::array<std::uint32_t, 3>> sorted(all.size());
    std::vector<std::uint32_t> order(all.size());
    for (std::uint32_t t = 0; t < all.size(); ++t) {
        sorted[t] = {point_of[all[t].x], point_of[all[t].y], point_of[all[t].z]};
        std::ranges::sort(sorted[t]);
        order[t] = t;
    }
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return sorted[t]; });
    std::vector<char> stays(all.size(), 1);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& own = sorted[order[i]];
        stays[order[i]] =
            own[0] != own[1] && own[1] != own[2] && (i == 0 || sorted[order[i - 1]] != own);
    }
    PointTriangles out;
    for (std::size_t t = 0; t < all.size(); ++t)
        for (int k = 0; stays[t] && k < 3; ++k) {
            out.corners.push_back(point_of[all[t][k]]);
            out.vertices.push_back(all[t][k]);
        }
    return out;
}

class PatchBuilder {
public:
    PatchBuilder(const Mesh& mesh, float crease_deg, const glm::mat3& stretch)
        : mesh_(mesh),
          to_normal_(glm::transpose(glm::inverse(stretch))),
          mirrored_(glm::determinant(stretch) < 0),
          least_cosine_(std::cos(glm::radians(crease_deg)))
    {
        const std::vector<std::uint32_t> point_of =
            mesh.points.empty() ? points_by_position(mesh.positions) : mesh.points;
        std::uint32_t count = 0;
        for (const std::uint32_t p : point_of) count = std::max(count, p + 1);
        shape_.points.resize(count);
        for (std::size_t v = 0; v < point_of.size(); ++v)
            shape_.points[point_of[v]] = stretch * mesh.positions[v];
        from_ = point_triangles(mesh, point_of);
        normals_.resize(from_.corners.size() / 3);
        for (std::size_t t = 0; t < normals_.size(); ++t) {
            const glm::dvec3 a = place(3 * t),
                             across = glm::cross(glm::dvec3(place(3 * t + 1)) - a,
                                                 glm::dvec3(place(3 * t + 2)) - a);
            const double length = glm::length(across);
            if (length > 0) normals_[t] = glm::vec3(across / (mirrored_ ? -length : length));
        }
    }
    MeshShape operator()()
    {
        const Adjacency adjacency(from_.corners, shape_.points.size());
        join_corners(adjacency);
        shape_.surface.size = size_of(shape_.surface.positions);
        shape_.surface.bends =
            surface_bends(shape_.surface.positions, shape_.surface.normals, shape_.surface.corners);
        return std::move(shape_);
    }

private:
    const glm::vec3& place(std::size_t corner) const
    {
        return shape_.points[from_.corners[corner]];
    }
    // Corners at a point are one vertex where the faces between them are one patch.
    void join_corners(const Adjacency& adjacency)
    {
        JoinedSets sets(from_.corners.size());
        shape_.closed = adjacency.edge_count() > 0;
        for (std::size_t e = 0; e < adjacency.edge_count(); ++e) {
            const std::span<const std::uint32_t> sides = adjacency.sides(e);
            const std::uint32_t s = sides[0], t = sides.size() > 1 ? sides[1] : s;
            const glm::vec3 &n = normals_[s / 3], &m = normals_[t / 3];
            if (sides.size() == 1) shape_.closed = false;
            const bool flat = n == glm::vec3(0) || m == glm::vec3(0); // of a triangle without area
            if (adjacency.is_manifold(e) && (flat || glm::dot(n, m) >= least_cosine_)) {
                sets.join(s, adjacency.next(t));
                sets.join(adjacency.next(s), t);
                continue;
            }
            const glm::uvec2 ends = adjacency.edges()[e];
            shape_.edges.push_back({ends.x, ends.y, n, m, sides.size() == 1});
        }
        take_vertices(sets);
    }
    void take_vertices(JoinedSets& sets)
    {
        constexpr std::uint32_t none = ~0u;
        SurfaceShape& out = shape_.surface;
        std::vector<std::uint32_t> vertex_of(from_.corners.size(), none);
        std::vector<glm::dvec3> of_faces, of_mesh;
        for (std::uint32_t c = 0; c < from_.corners.size(); ++c) {
            std::uint32_t& vertex = vertex_of[sets.root(c)];
            if (vertex == none) {
                vertex = static_cast<std::uint32_t>(out.positions.size());
                out.positions.push_back(place(c));
                of_faces.emplace_back(0);
                of_mesh.emplace_back(0);
            }
            out.corners.push_back(vertex);
            const std::uint32_t first = c - c % 3;
            const glm::dvec3 a(place(first + (c + 1) % 3) - place(c)),
                b(place(first + (c + 2) % 3) - place(c));
            const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            of_faces[vertex] += angle * glm::dvec3(normals_[c / 3]);
            if (!mesh_.normals.empty())
                of_mesh[vertex] +=
                    angle * glm::dvec3(to_normal_ * mesh_.normals[from_.vertices[c]]);
        }
        const auto unit = [](const glm::dvec3& n) {
            const double length = glm::length(n);
            return length > 0 ? n / length : glm::dvec3(0);
        };
        for (std::size_t v = 0; v < of_faces.size(); ++v) {
            const glm::dvec3 faces = unit(of_faces[v]), own = unit(of_mesh[v]);
            out.normals.emplace_back(glm::dot(faces, own) > goes_with_faces ? own : faces);
        }
    }

    const Mesh& mesh_;
    glm::mat3 to_normal_;
    bool mirrored_;
    float least_cosine_;
    PointTriangles from_;
    std::vector<glm::vec3> normals_; // of triangles
    MeshShape shape_;
};

} // namespace

MeshShape mesh_shape(const Mesh& mesh, float crease_deg, const glm::mat3& stretch)
{
    return PatchBuilder(mesh, crease_deg, stretch)();
}

Silhouettes outlines(const SurfaceShape& surface, const ViewPoint& view)
{
    check(view);
    std::vector<float> product(surface.positions.size());
    parallel_blocks(product.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            product[i] = static_cast<float>(glm::dot(glm::dvec3(surface.normals[i]),
                                                     view.sight(glm::dvec3(surface.positions[i]))));
    });
    Silhouettes out = zero_lines(
        surface, {product, {}, [](std::size_t, const std::array<float, 3>&) { return 1.0f; }},
        {.weak = 0, .strong = 0.5f, .smoothing = 0});
    for (SilhouettePoint& point : out.points) {
        const auto a = static_cast<std::size_t>(point.edge >> 32),
                   b = static_cast<std::size_t>(point.edge & 0xFFFFFFFF);
        const glm::vec3 sight(glm::normalize(view.sight(glm::dvec3(point.p))));
        const float from_a = glm::distance(point.p, surface.positions[a]),
                    from_b = glm::distance(point.p, surface.positions[b]);
        const float share = from_a + from_b > 0 ? from_a / (from_a + from_b) : 0.5f;
        point.bend = -glm::mix(surface.bends[a].along(sight), surface.bends[b].along(sight), share);
        point.strength = 1;
    }
    return out;
}

Silhouettes edge_lines(std::span<const glm::vec3> points, std::span<const MeshShape::Edge> edges)
{
    std::vector<std::uint32_t> degree(points.size(), 0), begin(points.size() + 1, 0);
    for (const MeshShape::Edge& edge : edges) {
        ++degree[edge.a];
        ++degree[edge.b];
    }
    for (std::size_t p = 0; p < points.size(); ++p) begin[p + 1] = begin[p] + degree[p];
    std::vector<std::uint32_t> at(2 * edges.size()), next(begin.begin(), begin.end() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        at[next[edges[e].a]++] = e;
        at[next[edges[e].b]++] = e;
    }
    const auto other = [&](std::uint32_t e, std::uint32_t p) {
        return edges[e].a == p ? edges[e].b : edges[e].a;
    };
    constexpr std::uint32_t none = ~0u;
    // The edge with which a line that comes to a point along another one goes on.
    const auto after = [&](std::uint32_t e, std::uint32_t p) {
        if (degree[p] != 2) return none;
        const std::uint32_t out = at[begin[p]] == e ? at[begin[p] + 1] : at[begin[p]];
        const glm::vec3 in_way = points[p] - points[other(e, p)],
                        out_way = points[other(out, p)] - points[p];
        return glm::dot(in_way, out_way) > goes_on * glm::length(in_way) * glm::length(out_way)
                   ? out
                   : none;
    };
    Silhouettes lines;
    std::vector<char> seen(edges.size(), 0);
    const auto walk = [&](std::uint32_t e, std::uint32_t from) {
        const std::uint32_t start = e;
        std::uint32_t p = from;
        const auto add = [&] {
            lines.points.push_back(
                {.p = points[p], .polished = true, .edge = edge_key(edges[e].a, edges[e].b)});
        };
        while (true) {
            seen[e] = 1;
            add();
            p = other(e, p);
            const std::uint32_t out = after(e, p);
            const bool closes = out == start;
            if (out == none || closes || seen[out]) {
                if (!closes) add();
                lines.closed.push_back(closes);
                break;
            }
            e = out;
        }
        lines.first.push_back(static_cast<std::uint32_t>(lines.points.size()));
    };
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        for (const std::uint32_t end : {edges[e].a, edges[e].b})
            if (!seen[e] && after(e, end) == none) walk(e, end);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        if (!seen[e]) walk(e, edges[e].a);
    return lines;
}

} // namespace trivar
