// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/fans.h"

#include "core/base/joined_sets.h"
#include "core/mesh/adjacency.h"
#include "core/simplify/alike.h"

#include <algorithm>

namespace trivar {
namespace {

class FanBuilder {
public:
    explicit FanBuilder(const Mesh& mesh) : mesh_(mesh), edges_(take_triangles()) {}

    Fans built()
    {
        leave_out();
        take_nodes();
        take_rails();
        take_shading();
        return std::move(out_);
    }

private:
    // Builds the adjacency of the triangles: corner 3 t + i is corner i of triangle t.
    Adjacency take_triangles()
    {
        out_.triangles = triangles(mesh_);
        out_.first_equal = first_equal_vertices(mesh_);
        std::vector<std::uint32_t> corner_points;
        corner_points.reserve(3 * out_.triangles.size());
        for (glm::uvec3& t : out_.triangles)
            for (int i = 0; i < 3; ++i) {
                t[i] = out_.first_equal[t[i]];
                corner_points.push_back(mesh_.point(t[i]));
            }
        out_.face.reserve(out_.triangles.size());
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f)
            out_.face.insert(out_.face.end(), mesh_.face_begin[f + 1] - mesh_.face_begin[f] - 2, f);
        return {std::move(corner_points), mesh_.vertex_count() == 0 ? 0 : point_count(mesh_)};
    }

    std::uint32_t vertex(std::uint32_t corner) const
    {
        return out_.triangles[corner / 3][static_cast<int>(corner % 3)];
    }
    std::uint32_t node(std::uint32_t corner) const
    {
        return out_.nodes[corner / 3][static_cast<int>(corner % 3)];
    }
    bool is_in(std::uint32_t triangle) const { return out_.nodes[triangle].x != Fans::none; }

    void leave_out()
    {
        out_.nodes.assign(out_.triangles.size(), glm::uvec3(0));
        for (std::uint32_t e = 0; e < edges_.edge_count(); ++e) {
            const glm::uvec2 ends = edges_.edges()[e];
            if (ends.x != ends.y && (edges_.is_border(e) || edges_.is_manifold(e))) continue;
            for (const std::uint32_t side : edges_.sides(e))
                out_.nodes[side / 3] = glm::uvec3(Fans::none);
        }
        for (std::uint32_t t = 0; t < out_.triangles.size(); ++t) out_.left_out += !is_in(t);
    }

    // Makes the nodes: corners at the same end of a shared edge are in one fan.
    void take_nodes()
    {
        JoinedSets corners(3 * out_.triangles.size());
        for (std::uint32_t e = 0; e < edges_.edge_count(); ++e)
            if (const auto [one, other] = both_in(e); other != Fans::none) {
                corners.join(one, edges_.next(other));
                corners.join(edges_.next(one), other);
            }
        std::vector<std::uint32_t> node_of(3 * out_.triangles.size(), Fans::none); // by root
        for (std::size_t p = 0; p < edges_.point_count(); ++p) {
            const std::size_t first = out_.vertex.size();
            bool all_in = true;
            for (const std::uint32_t c : edges_.corners(p)) {
                if (!is_in(c / 3)) {
                    all_in = false;
                    continue;
                }
                std::uint32_t& node = node_of[corners.root(c)];
                if (node == Fans::none) {
                    node = static_cast<std::uint32_t>(out_.vertex.size());
                    out_.vertex.push_back(vertex(c));
                }
                out_.nodes[c / 3][static_cast<int>(c % 3)] = node;
            }
            const bool alone = all_in && out_.vertex.size() == first + 1;
            out_.shared.resize(out_.vertex.size(), !alone);
        }
        out_.fixed = out_.shared;
    }

    // Returns the sides of an edge that decimation sees: none, one or two.
    std::pair<std::uint32_t, std::uint32_t> both_in(std::uint32_t edge) const
    {
        std::pair out(Fans::none, Fans::none);
        for (const std::uint32_t side : edges_.sides(edge))
            if (is_in(side / 3)) (out.first == Fans::none ? out.first : out.second) = side;
        return out;
    }

    // A Difference lists the differences between the two sides of an edge: the faces, or the values
    // at one end or both.
    struct Difference {
        bool faces, here, there; // here: where the first side begins
        bool line() const { return faces || (here && there); }
        bool any() const { return faces || here || there; }
    };
    Difference difference(std::uint32_t one, std::uint32_t other) const
    {
        const std::uint32_t f = out_.face[one / 3], g = out_.face[other / 3];
        const auto of_faces = [&](const std::vector<std::uint32_t>& values) {
            return !values.empty() && values[f] != values[g];
        };
        return {of_faces(mesh_.face_material) || of_faces(mesh_.face_group),
                !alike(mesh_, vertex(one), vertex(edges_.next(other))),
                !alike(mesh_, vertex(edges_.next(one)), vertex(other))};
    }

    void take_rails()
    {
        std::vector<float> sharpness(edges_.edge_count(), 0);
        for (const Mesh::Crease& crease : mesh_.creases) {
            const std::uint32_t a = mesh_.point(crease.a), b = mesh_.point(crease.b);
            const auto edge = edges_.edge_between(a, b);
            if (a == b) fix_point(a);
            if (edge && both_in(*edge).first != Fans::none)
                sharpness[*edge] = std::max(sharpness[*edge], crease.sharpness);
            else if (edge || a == b)
                out_.kept_creases.push_back(crease);
        }
        struct Ends {
            int count = 0;
            float sharpness = 0;
        };
        std::vector<Ends> at(out_.vertex.size());
        for (std::uint32_t e = 0; e < edges_.edge_count(); ++e) {
            const auto [one, other] = both_in(e);
            if (one == Fans::none) continue;
            if (other != Fans::none && sharpness[e] == 0) {
                const Difference sides = difference(one, other);
                // A seam ends here, or all edges of a pole are seams.
                if (sides.here != sides.there)
                    out_.fixed[node(sides.here ? one : edges_.next(one))] = true;
                if (!sides.line()) continue;
            }
            out_.rails.push_back({node(one), node(edges_.next(one)), sharpness[e]});
            for (const std::uint32_t n : {node(one), node(edges_.next(one))}) {
                if (at[n].count++ == 0) at[n].sharpness = sharpness[e];
                if (at[n].sharpness != sharpness[e]) out_.fixed[n] = true;
            }
        }
        for (std::size_t n = 0; n < at.size(); ++n)
            if (at[n].count != 0 && at[n].count != 2) out_.fixed[n] = true;
    }

    void fix_point(std::uint32_t point)
    {
        for (const std::uint32_t c : edges_.corners(point))
            if (is_in(c / 3)) out_.fixed[node(c)] = true;
    }

    void take_shading()
    {
        out_.hard.assign(out_.vertex.size(), false);
        out_.faceted.assign(out_.triangles.size(), false);
        if (mesh_.normals.empty()) return;
        for (std::uint32_t c = 0; c < 3 * out_.triangles.size(); ++c)
            if (is_in(c / 3) && !smooth(mesh_, vertex(c), out_.vertex[node(c)]))
                out_.hard[node(c)] = true;
        for (std::uint32_t e = 0; e < edges_.edge_count(); ++e) {
            const auto [one, other] = both_in(e);
            if (other == Fans::none || difference(one, other).any()) continue;
            if (mesh_.normals[vertex(one)] == mesh_.normals[vertex(edges_.next(other))] &&
                mesh_.normals[vertex(other)] == mesh_.normals[vertex(edges_.next(one))])
                continue;
            for (const std::uint32_t t : {one / 3, other / 3})
                if (!out_.faceted[t]) out_.faceted[t] = has_its_own_normal(t);
        }
    }

    bool has_its_own_normal(std::uint32_t t) const
    {
        constexpr double cos_same = 0.999; // triangles of one polygon may be at an angle
        const glm::uvec3 v = out_.triangles[t];
        const auto p = [&](int i) { return glm::dvec3(mesh_.positions[v[i]]); };
        const glm::dvec3 normal = glm::cross(p(1) - p(0), p(2) - p(0));
        for (int i = 0; i < 3; ++i)
            if (!(glm::dot(glm::dvec3(mesh_.normals[v[i]]), normal) >=
                  cos_same * glm::length(normal)))
                return false;
        return true;
    }

    const Mesh& mesh_;
    Fans out_;
    Adjacency edges_;
};

} // namespace

Fans fans_of(const Mesh& mesh)
{
    return FanBuilder(mesh).built();
}

} // namespace trivar
