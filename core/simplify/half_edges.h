// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/decimation_values.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>

namespace trivar {

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;
using HalfEdge = HalfEdges::HalfedgeHandle;
// A Collapse is a half-edge v0 -> v1 along which v0 is removed, with its neighbourhood.
struct Collapse : OpenMesh::Decimater::CollapseInfoT<HalfEdges> {
    Collapse(HalfEdges& half_edges, HalfEdge along) : CollapseInfoT(half_edges, along) {}
};

inline std::size_t index(OpenMesh::BaseHandle handle)
{
    return static_cast<std::size_t>(handle.idx());
}

// FanHalfEdges are the triangles of fans as OpenMesh's half-edges, with the vertices of their
// corners. Nodes keep their numbers in the fans; faces follow the triangles that are not left out.
// Rails are edges with the status `feature`, as are the nodes on them; fixed nodes are `locked`.
class FanHalfEdges {
public:
    explicit FanHalfEdges(const Fans& fans);

    HalfEdges& half_edges() { return half_edges_; }
    const HalfEdges& half_edges() const { return half_edges_; }
    const std::vector<glm::uvec3>& nodes() const { return nodes_; }       // by face
    const std::vector<glm::uvec3>& vertices() const { return vertices_; } // by face
    std::uint32_t vertex(OpenMesh::FaceHandle face, OpenMesh::VertexHandle node) const
    {
        return vertices_[index(face)][corner(face, node)];
    }
    bool is_rail(HalfEdge h) const
    {
        return half_edges_.status(half_edges_.edge_handle(h)).feature();
    }

    // Calls use(face, corner of v0, the vertex of v1 that it gets) for every face that a collapse
    // moves, until it returns false. It goes from the collapsed edge to either side up to a rail:
    // beyond the rail faces have the vertex of the other side.
    template <class Use> bool each_moved_face(const Collapse& c, Use use) const
    {
        const auto moved = [&](OpenMesh::FaceHandle face, std::uint32_t vertex) {
            return face == c.fl || face == c.fr || use(index(face), corner(face, c.v0), vertex);
        };
        if (c.fl.is_valid()) {
            const std::uint32_t goal = vertex(c.fl, c.v1);
            HalfEdge h = half_edges_.ccw_rotated_halfedge_handle(c.v0v1);
            for (; h != c.v0v1 && !is_rail(h); h = half_edges_.ccw_rotated_halfedge_handle(h))
                if (!moved(half_edges_.face_handle(h), goal)) return false;
            if (h == c.v0v1) return true; // all round
        }
        if (c.fr.is_valid()) {
            const std::uint32_t goal = vertex(c.fr, c.v1);
            HalfEdge h = half_edges_.cw_rotated_halfedge_handle(c.v0v1);
            for (; !is_rail(h); h = half_edges_.cw_rotated_halfedge_handle(h))
                if (!moved(half_edges_.opposite_face_handle(h), goal)) return false;
        }
        return true;
    }

    void collapse(const Collapse& c);
    Decimation result(const Fans& fans) const;

private:
    int corner(OpenMesh::FaceHandle face, OpenMesh::VertexHandle node) const
    {
        const glm::uvec3& of = nodes_[index(face)];
        const auto n = static_cast<std::uint32_t>(node.idx());
        return of.x == n ? 0 : of.y == n ? 1 : 2;
    }
    void take_rails(const std::vector<Fans::Rail>& rails);
    void join(HalfEdge one, HalfEdge other);

    HalfEdges half_edges_;
    std::size_t refused_ = 0;
    std::vector<std::uint32_t> triangle_;      // by face, of Fans
    std::vector<glm::uvec3> nodes_, vertices_; // by face
    std::vector<bool> changed_;                // by face
    std::vector<float> sharpness_;             // by edge
};

} // namespace trivar
