// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/half_edges.h"

#include <algorithm>

namespace trivar {
namespace {

OpenMesh::VertexHandle node_handle(std::uint32_t node)
{
    return OpenMesh::VertexHandle(static_cast<int>(node));
}

} // namespace

FanHalfEdges::FanHalfEdges(const Fans& fans)
{
    half_edges_.request_vertex_status();
    half_edges_.request_edge_status();
    half_edges_.request_face_status();
    const std::size_t nodes = fans.vertex.size(), triangles = fans.triangles.size();
    half_edges_.reserve(nodes, 3 * triangles / 2, triangles);
    for (std::size_t n = 0; n < nodes; ++n)
        half_edges_.status(half_edges_.add_vertex({})).set_locked(fans.fixed[n]);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const glm::uvec3 n = fans.nodes[t];
        if (n.x == Fans::none) continue;
        if (!half_edges_.add_face(node_handle(n.x), node_handle(n.y), node_handle(n.z))
                 .is_valid()) { // faces that OpenMesh cannot add stay unchanged
            for (int i = 0; i < 3; ++i) half_edges_.status(node_handle(n[i])).set_locked(true);
            ++refused_;
            continue;
        }
        triangle_.push_back(t);
        nodes_.push_back(n);
        vertices_.push_back(fans.triangles[t]);
    }
    changed_.assign(triangle_.size(), false);
    take_rails(fans.rails);
}

void FanHalfEdges::take_rails(const std::vector<Fans::Rail>& rails)
{
    sharpness_.assign(half_edges_.n_edges(), 0);
    for (const Fans::Rail& rail : rails) {
        const auto a = node_handle(rail.a), b = node_handle(rail.b);
        const HalfEdge h = half_edges_.find_halfedge(a, b);
        if (!h.is_valid()) continue; // of a triangle that was refused
        const auto edge = half_edges_.edge_handle(h);
        half_edges_.status(edge).set_feature(true);
        half_edges_.status(a).set_feature(true);
        half_edges_.status(b).set_feature(true);
        sharpness_[index(edge)] = rail.sharpness;
    }
}

void FanHalfEdges::collapse(const Collapse& c)
{
    each_moved_face(c, [&](std::size_t f, int corner, std::uint32_t vertex) {
        vertices_[f][corner] = vertex;
        nodes_[f][corner] = static_cast<std::uint32_t>(c.v1.idx());
        changed_[f] = true;
        return true;
    });
    // Either of the two edges that become one may be the one that remains.
    if (c.fl.is_valid()) join(c.v0vl, c.vlv1);
    if (c.fr.is_valid()) join(c.vrv0, c.v1vr);
    half_edges_.collapse(c.v0v1);
}

void FanHalfEdges::join(HalfEdge one, HalfEdge other)
{
    if (!is_rail(one) && !is_rail(other)) return;
    const auto a = half_edges_.edge_handle(one), b = half_edges_.edge_handle(other);
    half_edges_.status(a).set_feature(true);
    half_edges_.status(b).set_feature(true);
    float &x = sharpness_[index(a)], &y = sharpness_[index(b)];
    x = y = std::max(x, y);
}

Decimation FanHalfEdges::result(const Fans& fans) const
{
    Decimation out{fans.triangles, fans.nodes, std::vector<bool>(fans.triangles.size()), {}, 0};
    out.count = refused_;
    for (const auto face : half_edges_.all_faces()) {
        const std::uint32_t t = triangle_[index(face)];
        const bool gone = half_edges_.status(face).deleted();
        out.triangles[t] = vertices_[index(face)];
        out.nodes[t] = gone ? glm::uvec3(Fans::none) : nodes_[index(face)];
        out.changed[t] = gone || changed_[index(face)];
        out.count += !gone;
    }
    for (const auto edge : half_edges_.all_edges()) {
        const float sharpness = sharpness_[index(edge)];
        if (half_edges_.status(edge).deleted() || sharpness <= 0) continue;
        const HalfEdge h = half_edges_.halfedge_handle(edge, 0);
        out.creases.push_back({static_cast<std::uint32_t>(half_edges_.from_vertex_handle(h).idx()),
                               static_cast<std::uint32_t>(half_edges_.to_vertex_handle(h).idx()),
                               sharpness});
    }
    return out;
}

} // namespace trivar
