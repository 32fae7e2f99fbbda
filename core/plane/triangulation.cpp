// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plane/triangulation.h"

#include "core/base/mistake.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using NumberedVertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using MarkedFace = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<bool, Kernel>>; // bool: inside the region
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<NumberedVertex, MarkedFace>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Face = Delaunay::Face_handle; // side i runs from vertex(ccw(i)) to vertex(cw(i))

Triangulation::Corners corners_of(Face f)
{
    return {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
}

bool has_longer_edge(Face f, double length)
{
    for (int i = 0; i < 3; ++i)
        if (CGAL::squared_distance(f->vertex(i)->point(), f->vertex(Delaunay::cw(i))->point()) >
            length * length)
            return true;
    return false;
}

bool on_fixed_edge(Face f, const Delaunay::Point& p)
{
    for (int i = 0; i < 3; ++i)
        if (f->is_constrained(i) && CGAL::collinear(f->vertex(Delaunay::ccw(i))->point(),
                                                    f->vertex(Delaunay::cw(i))->point(), p))
            return true;
    return false;
}

glm::ivec2 on_grid(const Delaunay::Point& p)
{
    return glm::ivec2(glm::round(glm::dvec2(p.x(), p.y())));
}

} // namespace

struct Triangulation::Plane {
    Delaunay delaunay;
    std::vector<Delaunay::Vertex_handle> vertices; // by number

    Delaunay::Vertex_handle vertex(int number) const
    {
        return vertices[static_cast<std::size_t>(number)];
    }
    std::optional<Face> face(const Corners& v) const
    {
        Face f;
        if (delaunay.is_face(vertex(v[0]), vertex(v[1]), vertex(v[2]), f)) return f;
        return std::nullopt;
    }
    Face left_of(int a, int b) const
    {
        Face f;
        int side = 0;
        const bool found = delaunay.is_edge(vertex(a), vertex(b), f, side);
        ensure(found, "what encloses a region is no edge");
        return f->vertex(Delaunay::ccw(side))->info() == a ? f : f->neighbor(side);
    }
    // Returns the number of the vertex at p, which is added if it is new. A face near p shortens
    // the search.
    int put(const glm::ivec2& p, Face near)
    {
        const auto v = delaunay.insert(Delaunay::Point(p.x, p.y), near);
        if (delaunay.number_of_vertices() > vertices.size()) {
            v->info() = static_cast<int>(vertices.size());
            vertices.push_back(v);
        }
        return v->info();
    }
    void mark_round(int point)
    {
        const auto first = delaunay.incident_faces(vertex(point));
        auto face = first;
        do face->info() = true;
        while (++face != first);
    }
    // Walks from a face to the one that contains p, without crossing a constrained edge; none if it
    // is behind one. The first side to try changes with each step, so that the walk does not cycle.
    std::optional<Face> face_in_sight(Face from, const Delaunay::Point& p) const
    {
        const std::size_t most = 4 * delaunay.number_of_faces() + 16;
        for (std::size_t step = 0; step < most; ++step) {
            int out = -1;
            for (std::size_t k = 0; k < 3 && out < 0; ++k) {
                const int i = static_cast<int>((k + step) % 3);
                if (CGAL::right_turn(from->vertex(Delaunay::ccw(i))->point(),
                                     from->vertex(Delaunay::cw(i))->point(), p))
                    out = i;
            }
            if (out < 0) return from;
            if (from->is_constrained(out)) return std::nullopt;
            from = from->neighbor(out);
        }
        return std::nullopt;
    }
};

Triangulation::Triangulation() : plane_(std::make_unique<Plane>()) {}
Triangulation::~Triangulation() = default;

int Triangulation::insert(const glm::ivec2& p, int near)
{
    const int from = near < 0 ? static_cast<int>(points_.size()) - 1 : near;
    const int point = plane_->put(p, from < 0 ? Face() : plane_->vertex(from)->face());
    if (point == static_cast<int>(points_.size())) points_.push_back(p);
    return point;
}

Triangulation::JoinResult Triangulation::join(int a, int b)
{
    const auto from = plane_->vertex(a), to = plane_->vertex(b);
    try {
        plane_->delaunay.insert_constraint(from, to);
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
        return JoinResult::crosses;
    }
    return plane_->delaunay.is_edge(from, to) ? JoinResult::one_edge : JoinResult::several;
}

bool Triangulation::fill(const std::vector<std::pair<int, int>>& edges)
{
    std::vector<std::pair<int, int>> rim;
    for (const auto& [a, b] : edges) rim.push_back(std::minmax(a, b));
    std::ranges::sort(rim);
    for (const Face f : plane_->delaunay.all_face_handles()) f->info() = false;
    std::vector<Face> open;
    bool enclosed = true;
    const auto enter = [&](Face f) {
        if (f->info()) return;
        f->info() = true;
        enclosed = enclosed && !plane_->delaunay.is_infinite(f);
        open.push_back(f);
    };
    for (const auto& [a, b] : edges) enter(plane_->left_of(a, b));
    while (!open.empty()) {
        const Face f = open.back();
        open.pop_back();
        const Corners v = corners_of(f);
        for (std::size_t i = 0; i < 3; ++i)
            if (!f->is_constrained(static_cast<int>(i)) ||
                !std::ranges::binary_search(
                    rim, std::pair<int, int>(std::minmax(v[(i + 1) % 3], v[(i + 2) % 3]))))
                enter(f->neighbor(static_cast<int>(i)));
    }
    // An edge has the inside on both sides where the edges run round it twice
    for (const auto& [a, b] : edges)
        if (const Face f = plane_->left_of(b, a); f->info()) enclosed = false;
    return enclosed;
}

void Triangulation::refine(double longest, const std::function<bool(const Corners&)>& may_split,
                           const std::function<void(int point, const Corners&)>& added)
{
    constexpr std::size_t most = 200000; // points, for a letter as large as the grid
    Delaunay& delaunay = plane_->delaunay;
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Corners> open;
        for (const Face f : delaunay.finite_face_handles())
            if (f->info() && has_longer_edge(f, longest)) open.push_back(corners_of(f));
        for (const Corners& v : open) {
            if (points_.size() >= most) return;
            const std::optional<Face> f = plane_->face(v);
            if (!f || !may_split(v)) continue;
            const Delaunay::Point centre = delaunay.circumcenter(*f);
            if (!(std::hypot(centre.x(), centre.y()) < most_units)) continue; // of a sliver
            const glm::ivec2 p = on_grid(centre);
            const std::optional<Face> in = plane_->face_in_sight(*f, Delaunay::Point(p.x, p.y));
            if (!in || on_fixed_edge(*in, Delaunay::Point(p.x, p.y))) continue;
            const Corners round = corners_of(*in);
            if (!may_split(round)) continue;
            const int point = plane_->put(p, *in);
            if (point < static_cast<int>(points_.size())) continue; // the point exists already
            points_.push_back(p);
            plane_->mark_round(point);
            added(point, round);
            changed = true;
        }
    }
}

std::vector<Triangulation::Corners> Triangulation::inside() const
{
    std::vector<Corners> result;
    for (const Face f : plane_->delaunay.finite_face_handles())
        if (f->info()) result.push_back(corners_of(f));
    return result;
}

} // namespace trivar
