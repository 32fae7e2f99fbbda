// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/collapse_cost.h"

#include "core/mesh/barycentric.h"
#include "core/simplify/alike.h"
#include "core/simplify/half_edges.h"

#include <algorithm>

namespace trivar {
namespace {

// Distances below this share of an edge count as 0. Of equal collapses the one along the shorter
// edge comes first, so that flat parts do not become slivers.
constexpr double unseen_share = 1e-3;
// A triangle is a sliver if twice its area, relative to the square of its longest edge, is below
// this.
constexpr double sliver = 1e-3;
// Black in place of white counts as a movement by this share of the size.
constexpr double color_share = 0.02;
// The greatest difference of a removed vertex from the colour that its place gets.
constexpr double most_color = 0.2;
constexpr double cos_turned = 0.2; // between the normals of a triangle before and after: 78 degrees

} // namespace

CollapseCost::CollapseCost(const Mesh& mesh, const Fans& fans, const FanHalfEdges& surface,
                           const NodePlaces& places, std::vector<double> tolerance)
    : mesh_(mesh),
      fans_(fans),
      surface_(surface),
      places_(places),
      tolerance_(std::move(tolerance)),
      any_shared_(std::ranges::find(fans.shared, true) != fans.shared.end()),
      faces_(places.size()),
      rails_(places.size())
{
    for (std::size_t pose = 0; pose < places.size(); ++pose) take_planes(pose);
    Box box;
    for (const glm::dvec3& p : places[0]) box.add(p);
    color_metres_ = color_share * glm::length(box.size());
}

void CollapseCost::take_planes(std::size_t pose)
{
    const std::vector<glm::dvec3>& at = places_[pose];
    std::vector<Planes>&faces = faces_[pose], &rails = rails_[pose];
    faces.resize(at.size());
    rails.resize(at.size());
    for (const auto face : surface_.half_edges().all_faces()) {
        const glm::uvec3 n = surface_.nodes()[index(face)];
        const glm::dvec3 across = glm::cross(at[n.y] - at[n.x], at[n.z] - at[n.x]);
        const double size = glm::length(across);
        if (!(size > 0)) continue;
        for (int i = 0; i < 3; ++i) faces[n[i]].add(across / size, at[n.x], size / 2);
        for (const auto h : surface_.half_edges().fh_range(face)) {
            if (!surface_.is_rail(h)) continue;
            const std::size_t a = index(surface_.half_edges().from_vertex_handle(h)),
                              b = index(surface_.half_edges().to_vertex_handle(h));
            const glm::dvec3 along = at[b] - at[a], upright = glm::cross(along, across);
            const double length = glm::length(upright);
            if (!(length > 0)) continue;
            for (const std::size_t end : {a, b})
                rails[end].add(upright / length, at[a], glm::dot(along, along));
        }
    }
}

std::optional<double> CollapseCost::operator()(const Collapse& c, double best) const
{
    if (joins_rails(c) || ends_a_seam(c) || meets_itself(c)) return std::nullopt;
    const std::size_t from = index(c.v0), to = index(c.v1);
    const bool any = tolerance_.empty();
    const double most = any ? 0 : std::min(tolerance_[from], tolerance_[to]);
    if (most < 0) return std::nullopt;
    const HalfEdges& half_edges = surface_.half_edges();
    const bool on_rail = half_edges.status(c.v0).feature() || half_edges.status(c.v1).feature();
    double sum = 0;
    for (std::size_t pose = 0; pose < places_.size(); ++pose) {
        const glm::dvec3& p = places_[pose][to];
        for (const auto* planes : {&faces_, &rails_}) {
            if (planes == &rails_ && !on_rail) break;
            const Planes &a = (*planes)[pose][from], &b = (*planes)[pose][to];
            const double error = a.at(p) + b.at(p);
            if (!any && error > most * most * (a.weight() + b.weight())) return std::nullopt;
            sum += error;
        }
        const glm::dvec3 edge = p - places_[pose][from];
        sum += unseen_share * unseen_share * glm::dot(edge, edge) * faces_[pose][from].weight();
    }
    if (!mesh_.colors.empty() && sum < best) {
        const double difference = color_difference(c), metres = color_metres_ * difference;
        if (difference > most_color) return std::nullopt;
        sum += metres * metres * faces_[0][from].weight();
    }
    if (!(sum < best) || !keeps_its_sides(c)) return std::nullopt;
    return sum;
}

// The greatest difference of the colours of the removed vertices, one for each side of a seam, from
// those that the new triangles have there.
double CollapseCost::color_difference(const Collapse& c) const
{
    const glm::dvec3& p = places_[0][index(c.v0)];
    struct Side {
        std::uint32_t vertex = Fans::none;
        double inside = -1e300; // how far the place is in the triangle that holds it best
        double difference = 0;
    };
    std::array<Side, 4> sides;
    const auto side_of = [&](std::uint32_t vertex) -> Side& {
        std::size_t s = 0;
        while (s + 1 < sides.size() && sides[s].vertex != vertex && sides[s].vertex != Fans::none)
            ++s;
        sides[s].vertex = vertex;
        return sides[s];
    };
    const auto differs = [&](std::uint32_t vertex, const glm::dvec4& color) {
        return glm::length(glm::dvec4(mesh_.colors[vertex]) - color);
    };
    for (const auto face : {c.fl, c.fr}) // all that there is where no triangle moves
        if (face.is_valid()) {
            const std::uint32_t vertex = surface_.vertex(face, c.v0);
            side_of(vertex).difference = differs(vertex, mesh_.colors[surface_.vertex(face, c.v1)]);
        }
    surface_.each_moved_face(c, [&](std::size_t f, int corner, std::uint32_t goal) {
        glm::uvec3 v = surface_.vertices()[f], n = surface_.nodes()[f];
        Side& side = side_of(v[corner]);
        v[corner] = goal;
        n[corner] = static_cast<std::uint32_t>(c.v1.idx());
        const std::array<glm::dvec3, 3> at{places_[0][n.x], places_[0][n.y], places_[0][n.z]};
        const glm::dvec3 shares = barycentric(p, at);
        const double inside = std::min({shares.x, shares.y, shares.z});
        if (!(inside > side.inside)) return true;
        glm::dvec3 near = glm::max(shares, glm::dvec3(0));
        near /= near.x + near.y + near.z;
        glm::dvec4 color(0);
        for (int i = 0; i < 3; ++i) color += near[i] * glm::dvec4(mesh_.colors[v[i]]);
        const std::uint32_t removed = surface_.vertices()[f][corner];
        side = {removed, inside, differs(removed, color)};
        return true;
    });
    double most = 0;
    for (const Side& side : sides) most = std::max(most, side.difference);
    return most;
}

void CollapseCost::after(const Collapse& c)
{
    const std::size_t from = index(c.v0), to = index(c.v1);
    for (std::size_t pose = 0; pose < places_.size(); ++pose) {
        faces_[pose][to].add(faces_[pose][from]);
        rails_[pose][to].add(rails_[pose][from]);
    }
    if (!tolerance_.empty()) tolerance_[to] = std::min(tolerance_[to], tolerance_[from]);
}

// Says whether the two edges that become one are both rails.
bool CollapseCost::joins_rails(const Collapse& c) const
{
    return (c.fl.is_valid() && surface_.is_rail(c.v0vl) && surface_.is_rail(c.vlv1)) ||
           (c.fr.is_valid() && surface_.is_rail(c.vrv0) && surface_.is_rail(c.v1vr));
}

// Says whether a collapse would end a seam: the two triangles of the edge have different vertices
// at the goal, so that the other triangles have no unique one.
bool CollapseCost::ends_a_seam(const Collapse& c) const
{
    return c.fl.is_valid() && c.fr.is_valid() && !surface_.is_rail(c.v0v1) &&
           !alike(mesh_, surface_.vertex(c.fl, c.v1), surface_.vertex(c.fr, c.v1));
}

// Says whether a new edge would coincide with one between other fans of the same points.
bool CollapseCost::meets_itself(const Collapse& c) const
{
    if (!any_shared_) return false;
    const HalfEdges& half_edges = surface_.half_edges();
    for (const auto node : half_edges.vv_range(c.v0)) {
        const bool here = fans_.shared[index(c.v1)], there = fans_.shared[index(node)];
        if (node == c.v1 || (!here && !there)) continue;
        if (half_edges.find_halfedge(c.v1, node).is_valid()) continue; // not new
        if ((here && there) || touches_twin(node.idx(), c.v1.idx()) ||
            touches_twin(c.v1.idx(), node.idx()))
            return true;
    }
    return false;
}

// Says whether a node has an edge to another node of the point of `other`; these have consecutive
// numbers.
bool CollapseCost::touches_twin(int node, int other) const
{
    const auto point = [&](int n) {
        return mesh_.point(fans_.vertex[static_cast<std::size_t>(n)]);
    };
    const int count = static_cast<int>(fans_.vertex.size());
    for (const int step : {-1, 1})
        for (int n = other + step; n >= 0 && n < count && point(n) == point(other); n += step)
            if (surface_.half_edges()
                    .find_halfedge(OpenMesh::VertexHandle(node), OpenMesh::VertexHandle(n))
                    .is_valid())
                return true;
    return false;
}

bool CollapseCost::keeps_its_sides(const Collapse& c) const
{
    return surface_.each_moved_face(c, [&](std::size_t f, int corner, std::uint32_t vertex) {
        for (const std::vector<glm::dvec3>& at : places_)
            if (turns_over(at, surface_.nodes()[f], corner, index(c.v1))) return false;
        for (const std::vector<glm::vec2>& uv : mesh_.uvs)
            if (turns_over(uv, surface_.vertices()[f], corner, vertex)) return false;
        return true;
    });
}

// Says whether a triangle turns over or becomes a sliver.
bool CollapseCost::turns_over(const std::vector<glm::dvec3>& places, const glm::uvec3& nodes,
                              int corner, std::size_t goal) const
{
    const glm::dvec3 &p = places[nodes[(corner + 1) % 3]], &q = places[nodes[(corner + 2) % 3]];
    const glm::dvec3 &old = places[nodes[corner]], &moved = places[goal];
    const glm::dvec3 was = glm::cross(p - old, q - old), is = glm::cross(p - moved, q - moved);
    const double size = glm::length(was), then = glm::length(is);
    if (!(glm::dot(was, is) >= cos_turned * size * then)) return true;
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    const double longest = std::max({square(q - p), square(p - moved), square(q - moved)});
    return then < sliver * longest && then < size;
}

bool CollapseCost::turns_over(const std::vector<glm::vec2>& uv, const glm::uvec3& vertices,
                              int corner, std::uint32_t goal) const
{
    const glm::dvec2 p(uv[vertices[(corner + 1) % 3]]), q(uv[vertices[(corner + 2) % 3]]);
    const auto twice_area = [&](std::uint32_t vertex) {
        const glm::dvec2 a = p - glm::dvec2(uv[vertex]), b = q - glm::dvec2(uv[vertex]);
        return a.x * b.y - a.y * b.x;
    };
    const double was = twice_area(vertices[corner]), is = twice_area(goal);
    return (was > 0 && is <= 0) || (was < 0 && is >= 0);
}

} // namespace trivar
