// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incised_mesh.h"

#include "core/incise/birth.h"
#include "core/mesh/mesh_region.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

using On = LatticePoint::On;
constexpr std::size_t room_per_triangle = 4; // vertices, to copy arrays but once

class RestMesh {
public:
    RestMesh(const SlitShape& shape, std::span<const Incision> incisions, const Mesh& mesh)
        : shape_(shape),
          skin_(shape.drawing.skin()),
          incisions_(incisions),
          mesh_(mesh),
          first_new_(static_cast<std::uint32_t>(mesh.vertex_count()))
    {
    }

    void make(IncisedMesh& out, std::span<const int> borders, std::span<const WallLayer> layers,
              RefPool<Mesh>& made)
    {
        Mesh rest = copied(made.take_back().value_or(Mesh()));
        if (!layers.empty() && rest.face_material.empty())
            rest.face_material.assign(rest.face_count(), 0);
        out.has_hole = !shape_.left_out.none();
        for (std::uint32_t t = 0; t < shape_.patch.triangles.size(); ++t) {
            if (shape_.left_out.patch_piece(t)) continue;
            const std::uint32_t face = skin_.face_of(shape_.patch.triangles[t].parent);
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) corners[k] = skin_vertex(t, k);
            add(rest, corners, face, material_of(face));
        }
        out.first_wall_face = static_cast<std::uint32_t>(rest.face_count());
        out.first_wall_vertex = first_new_ + static_cast<std::uint32_t>(births_.size());
        for (std::size_t w = 0; w < shape_.walls.walls.size(); ++w) {
            if (shape_.left_out.wall(w)) continue;
            const WallTriangle& wall = shape_.walls.walls[w];
            const std::uint32_t face = face_above(wall);
            const auto layer = static_cast<std::size_t>(
                std::ranges::upper_bound(borders, wall.floor ? wall.level - 1 : wall.level) -
                borders.begin());
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = wall_vertex(wall.corners[k], wall.floor);
            add(rest, corners, face, layers.empty() ? material_of(face) : layers[layer].material);
        }
        out.wall_tops = std::move(wall_tops_);
        add_births(rest, births_);
        for (const auto& [vertex, point] : new_points_) rest.points[vertex] = point;
        set_wall_normals(rest, out);
        set_wall_tangents(rest, out);
        keep_creases(rest);
        take_terms(out);
        out.rest = made.lend(std::move(rest));
    }

private:
    std::uint32_t material_of(std::uint32_t face) const
    {
        return mesh_.face_material.empty() ? 0 : mesh_.face_material[face];
    }
    void add(Mesh& rest, const std::array<std::uint32_t, 3>& corners, std::uint32_t face,
             std::uint32_t material)
    {
        add_face(rest, corners);
        if (!rest.face_material.empty()) rest.face_material.push_back(material);
        if (!rest.face_group.empty()) rest.face_group.push_back(mesh_.face_group[face]);
    }

    // The original without its creases and the faces of the patch, with room for more, in the
    // memory of `out`.
    Mesh copied(Mesh out) const
    {
        std::vector<std::uint32_t> faces;
        for (const std::uint32_t t : shape_.patch.replaced)
            if (faces.empty() || faces.back() != skin_.face_of(t))
                faces.push_back(skin_.face_of(t));
        for (const std::uint32_t t : shape_.left_out.skin) faces.push_back(skin_.face_of(t));
        std::ranges::sort(faces);
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        const std::size_t triangles = shape_.patch.triangles.size() + shape_.walls.walls.size();
        const std::size_t more = room_per_triangle * triangles;
        copy_others(out, mesh_, faces, more, triangles);
        out.creases.clear();
        return out;
    }

    std::uint32_t born(std::uint32_t vertex, const glm::uvec3& of, const glm::dvec3& weights)
    {
        births_.push_back({of, weights, vertex, glm::vec3(shape_.rest_position(vertex))});
        vertex_of_birth_.push_back(vertex);
        return first_new_ + static_cast<std::uint32_t>(births_.size()) - 1;
    }

    std::uint32_t mesh_vertex(std::uint32_t side) const // at its beginning
    {
        return skin_.vertices(side / 3)[static_cast<int>(side % 3)];
    }
    // The vertices at both ends of an edge as one of its sides sees them, the lower point's first.
    glm::uvec2 ends_of(std::uint32_t side) const
    {
        const glm::uvec2 ends(mesh_vertex(side), mesh_vertex(SlitSkin::next(side)));
        return skin_.from(side) < skin_.to(side) ? ends : glm::uvec2(ends.y, ends.x);
    }
    // The side of a point's edge whose attributes it has in a triangle: the lower one but at seams.
    std::uint32_t side_seen_from(const LatticePoint& p, std::uint32_t triangle) const
    {
        const std::uint32_t other = skin_.across(p.index);
        if (other == SlitSkin::none || other / 3 != triangle) return p.index;
        return ends_of(other) == ends_of(p.index) ? p.index : other;
    }

    // The vertex of the result for a corner of a piece of the skin: one for each vertex of the
    // cut and each set of attributes that the mesh has there.
    std::uint32_t skin_vertex(std::uint32_t piece, std::size_t k)
    {
        const SkinTriangle& t = shape_.patch.triangles[piece];
        const std::uint32_t vertex = shape_.walls.skin[piece][k];
        const LatticePoint p = shape_.drawing.point(t.points[k]);
        const Blend blend = blend_of(skin_, p);
        const auto known = [&](std::uint64_t attributes) {
            return skin_number_.find(pair_key(vertex, static_cast<std::uint32_t>(attributes)));
        };
        const auto keep = [&](std::uint32_t attributes, std::uint32_t number) {
            skin_number_.insert(pair_key(vertex, attributes), number);
            return number;
        };
        if (p.on == On::point) {
            std::uint32_t v = 0;
            for (int i = 0; i < 3; ++i)
                if (skin_.triangle(t.parent)[i] == p.index) v = skin_.vertices(t.parent)[i];
            if (shape_.patch.sectors[piece][k] == KeyNumbers::none) return v;
            if (const std::uint32_t number = known(v); number != KeyNumbers::none) return number;
            if (!taken_.number(v).second) return keep(v, born(vertex, glm::uvec3(v), {1, 0, 0}));
            new_points_.emplace_back(v, vertex);
            return keep(v, v);
        }
        if (p.on == On::edge) {
            const std::uint32_t side = side_seen_from(p, t.parent);
            if (const std::uint32_t number = known(side); number != KeyNumbers::none) return number;
            const glm::uvec2 ends = ends_of(side);
            return keep(side, born(vertex, {ends.x, ends.y, ends.y}, blend.weights));
        }
        if (const std::uint32_t number = known(0); number != KeyNumbers::none) return number;
        return keep(0, born(vertex, skin_.vertices(p.index), blend.weights));
    }

    std::uint32_t wall_vertex(const WallCorner& c, bool floor)
    {
        const SlitNode& node = shape_.graph.nodes[c.node];
        const auto key = [&](std::uint32_t edge) { // of the cut that passes, and where
            const SlitEdge& e = shape_.graph.edges[edge];
            const SlitEdge::Pass& pass = e.passes.front();
            return std::pair(shape_.pieces[pass.piece].run,
                             e.starts_at(node.point) ? pass.s_a : pass.s_b);
        };
        const auto of = key(c.edge);
        std::uint32_t group = 0;
        while (key(node.edges[group]) != of) ++group;
        const std::uint32_t kind = (floor ? 1u << 31 : 0u) | c.sector << 15 | group;
        const auto [number, fresh] = wall_number_.insert(
            pair_key(c.vertex, kind), first_new_ + static_cast<std::uint32_t>(births_.size()));
        if (!fresh) return number;
        const LatticePoint p = shape_.drawing.point(node.point);
        glm::uvec3 vertices(0);
        if (p.on == On::point)
            skin_.around(p.index,
                         [&](std::uint32_t side) { vertices = glm::uvec3(mesh_vertex(side)); });
        else if (p.on == On::edge)
            vertices = {ends_of(p.index), ends_of(p.index).y};
        else
            vertices = skin_.vertices(p.index);
        born(c.vertex, vertices, blend_of(skin_, p).weights);
        BirthVertex& birth = births_.back();
        birth.wall = true;
        wall_tops_.emplace_back(shape_.drawing.position(node.point));
        double down = shape_.depth(c.vertex);
        if (floor) { // across it, beyond the left wall
            const SlitEdge& e = shape_.graph.edges[c.edge];
            const std::size_t i = node.edge_number(c.edge);
            const bool right = e.starts_at(node.point) ? c.sector != i : c.sector == i;
            const SlitRun& run = shape_.runs[of.first];
            if (right) down += incisions_[run.incision].floor_width * run.width;
        }
        const SlitRun& run = shape_.runs[of.first];
        const bool far = run.kind == SlitRun::Kind::far_side;
        if (far) down = depth_at(run, of.second);
        birth.uv = glm::vec2(far ? run.own_share(of.second) * run.near_length : of.second, down);
        return number;
    }

    std::uint32_t face_above(const WallTriangle& wall) const
    {
        const SlitEdge& e = shape_.graph.edges[wall.corners[0].edge];
        const std::uint32_t t = shape_.patch.triangle_of_side.find(pair_key(e.a, e.b));
        return skin_.face_of(shape_.patch.triangles[t].parent);
    }

    void set_wall_normals(Mesh& rest, const IncisedMesh& out) const
    {
        if (rest.normals.empty()) return;
        std::vector<glm::dvec3> sums(rest.vertex_count() - out.first_wall_vertex, glm::dvec3(0));
        for (std::size_t f = out.first_wall_face; f < rest.face_count(); ++f)
            for (std::uint32_t c = rest.face_begin[f]; c < rest.face_begin[f + 1]; ++c)
                sums[rest.corners[c] - out.first_wall_vertex] += area_normal(rest, f);
        for (std::size_t v = 0; v < sums.size(); ++v) {
            const double length = glm::length(sums[v]);
            if (length > 0) rest.normals[out.first_wall_vertex + v] = glm::vec3(sums[v] / length);
        }
    }

    // Along the first texture coordinate, as the walls stand at rest.
    void set_wall_tangents(Mesh& rest, const IncisedMesh& out) const
    {
        if (rest.tangents.empty() || rest.uvs.empty()) return;
        const std::uint32_t first = out.first_wall_vertex;
        std::vector<glm::dvec3> along(rest.vertex_count() - first, glm::dvec3(0)), down = along;
        for (std::size_t f = out.first_wall_face; f < rest.face_count(); ++f) {
            const std::uint32_t* const c = rest.corners.data() + rest.face_begin[f];
            const auto p = [&](int i) { return glm::dvec3(rest.positions[c[i]]); };
            const auto uv = [&](int i) { return glm::dvec2(rest.uvs[0][c[i]]); };
            const glm::dvec2 s = uv(1) - uv(0), t = uv(2) - uv(0);
            const double det = s.x * t.y - s.y * t.x;
            if (det == 0) continue;
            for (int i = 0; i < 3; ++i) {
                along[c[i] - first] += (t.y * (p(1) - p(0)) - s.y * (p(2) - p(0))) / det;
                down[c[i] - first] += (s.x * (p(2) - p(0)) - t.x * (p(1) - p(0))) / det;
            }
        }
        for (std::size_t v = 0; v < along.size(); ++v) {
            const glm::dvec3 n(rest.normals.empty() ? glm::vec3(0) : rest.normals[first + v]);
            const glm::dvec3 t = along[v] - glm::dot(along[v], n) * n;
            const double length = glm::length(t);
            if (!(length > 0)) continue;
            const float w = glm::dot(glm::cross(n, t), down[v]) < 0 ? -1.0f : 1.0f;
            rest.tangents[first + v] = glm::vec4(glm::vec3(t / length), w);
        }
    }

    // Creases whose edge got points inside are left out.
    void keep_creases(Mesh& rest) const
    {
        for (const Mesh::Crease& crease : mesh_.creases) {
            bool whole = true;
            const std::uint32_t to = mesh_.point(crease.b);
            skin_.around(mesh_.point(crease.a), [&](std::uint32_t side) {
                for (const std::uint32_t each : {side, SlitSkin::previous(side)})
                    if ((skin_.to(each) == to || skin_.from(each) == to) &&
                        shape_.drawing.on_edge(skin_.edge(each)))
                        whole = false;
            });
            if (whole) rest.creases.push_back(crease);
        }
    }

    void take_terms(IncisedMesh& out) const
    {
        KeyNumbers slots(shape_.terms.size()); // by vertex of the cut
        for (const SlitTerm& term : shape_.terms)
            out.terms.push_back(
                {slots.number(term.vertex).first, term.incision, term.share, term.held, term.move});
        out.slots = slots.size();
        KeyNumbers listed(shape_.terms.size() + births_.size());
        const auto list = [&](std::uint32_t vertex, std::uint32_t cut_vertex) {
            const std::uint32_t slot = slots.find(cut_vertex);
            if (slot == KeyNumbers::none || !listed.number(vertex).second) return;
            out.moved.push_back(vertex);
            out.slot_of_moved.push_back(slot);
        };
        for (const auto& [vertex, cut_vertex] : new_points_) list(vertex, cut_vertex);
        for (std::uint32_t i = 0; i < births_.size(); ++i)
            list(first_new_ + i, vertex_of_birth_[i]);
        for (const SlitTerm& term : shape_.terms) {
            if (term.vertex >= skin_.point_count()) continue;
            if (shape_.graph.node_of_point.contains(term.vertex)) continue; // listed above
            skin_.around(term.vertex,
                         [&](std::uint32_t side) { list(mesh_vertex(side), term.vertex); });
        }
    }

    const SlitShape& shape_;
    const SlitSkin& skin_;
    std::span<const Incision> incisions_;
    const Mesh& mesh_;
    std::uint32_t first_new_;
    std::vector<BirthVertex> births_;
    std::vector<std::uint32_t> vertex_of_birth_;
    std::vector<glm::vec3> wall_tops_;                                // by birth of a wall
    std::vector<std::pair<std::uint32_t, std::uint32_t>> new_points_; // of vertices of the mesh
    KeyNumbers taken_; // vertices of the mesh at nodes that some vertex of the cut has kept
    KeyNumbers skin_number_, wall_number_;
};

} // namespace

void make_rest(IncisedMesh& incised, const SlitShape& shape, std::span<const Incision> incisions,
               std::span<const int> borders, std::span<const WallLayer> layers, RefPool<Mesh>& made)
{
    RestMesh(shape, incisions, *incised.original).make(incised, borders, layers, made);
}

} // namespace trivar
