// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/refine.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/refinement/composed_bounds.h"
#include "core/refinement/shared_triangles.h"
#include "core/refinement/split_point.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

using Index = SharedTriangles::Index;
using Edge = SharedTriangles::Edge;
using Triangle = SharedTriangles::Triangle;
// At this depth an edge of half a kilometre is below a millimetre, the limit of single precision.
constexpr int most_depth = 20;

class Refinement {
public:
    Refinement(const std::vector<RefinePart>& parts, const Lattice& lattice,
               const RefineOptions& options, const Progress& progress,
               const std::vector<NextVolume>& next)
        : options_(options),
          progress_(progress),
          cells_(lattice, next),
          all_(parts, lattice, cells_.next())
    {
        for (int a = 0; a < 3; ++a)
            scale_[a] = cells_.first()->slopes()[a] + glm::length(glm::dvec3(lattice.rest[a]));
        measure_rounding(parts);
    }
    void split();
    RefinementResult result();

private:
    void measure_rounding(const std::vector<RefinePart>& parts);
    // Runs parallel_blocks in slices, and reports progress between them.
    void each_block(std::size_t count, std::size_t grain, const auto& work) const
    {
        constexpr std::size_t slice = 65536;
        for (std::size_t first = 0; first < count; first += slice) {
            report(progress_, done_, "refining");
            parallel_blocks(
                std::min(slice, count - first), grain,
                [&](std::size_t begin, std::size_t end) { work(first + begin, first + end); });
        }
    }
    void bound_edges();
    void bound_triangles(bool also_marked);
    void mark();
    void keep_to_budget();
    void choose_split_points();
    bool can_split(const Edge& edge) const;
    bool any_marked(const Triangle& triangle) const;
    Index worst_edge(const Triangle& triangle) const;
    Index edge_of_needle(const Triangle& triangle) const;
    // Bounds the error of an edge or a triangle; its four parts are bounded only if that can change
    // what is done.
    double bound(ComposedBounds& bounds, const auto& simplex, double target) const;
    // Bounds the part of the tolerance that single precision uses at a point, by the rounding of
    // its vertices and of their deformed positions; the largest in an edge or a triangle; and the
    // rest that is left.
    double rounding(const SharedTriangles::Point& point) const
    {
        return point.misplaced + point.moved * stretch_;
    }
    double rounding(const Edge& edge) const
    {
        return std::max(rounding(all_.points()[edge.a]), rounding(all_.points()[edge.b]));
    }
    double rounding(const Triangle& triangle) const
    {
        double most = 0;
        for (const Index e : triangle.edges) most = std::max(most, rounding(all_.edges()[e]));
        return most;
    }
    double target(const auto& simplex) const
    {
        return options_.tolerance_world - rounding(simplex);
    }

    RefineOptions options_;
    const Progress& progress_;
    double done_ = 0; // share of the edges that are done
    ComposedCells cells_;
    SharedTriangles all_;
    std::size_t first_new_edge_ = 0;
    glm::dvec3 scale_{0}; // bounds of world units per u, v and w
    double shortest_ = 0; // edges up to this length are not split
    double stretch_ = 0;  // largest ratio of a deformed to an undeformed step
    bool out_of_budget_ = false, marked_ = false;
};

// Measures rounding: single precision rounds every born vertex and every deformed position.
void Refinement::measure_rounding(const std::vector<RefinePart>& parts)
{
    Box box;
    double misplaced = 0, finest = 0;
    for (const auto& point : all_.points()) {
        box.add(point.rest_world);
        misplaced = std::max(misplaced, point.misplaced);
    }
    for (const RefinePart& part : parts) {
        double far = 0;
        for (const glm::vec3& x : part.mesh->positions)
            far = std::max(far, glm::length(glm::dvec3(x)));
        const Embedding& e = part.embedding;
        double squared = 0;
        for (int c = 0; c < 3; ++c)
            squared += glm::dot(glm::dvec3(e.to_rest[c]), glm::dvec3(e.to_rest[c]));
        double stretch = std::sqrt(squared);
        for (int a = 0; a < 3; ++a)
            stretch += cells_.first()->slopes()[a] *
                       glm::length(glm::dvec3(e.to_uvw[0][a], e.to_uvw[1][a], e.to_uvw[2][a]));
        stretch_ = std::max(stretch_, stretch * cells_.most_stretch());
        finest = std::max(finest, far * 0x1p-23);
    }
    shortest_ = std::max(1e-6 * glm::length(box.size()), 16 * finest);
    if (const double least = misplaced + finest * stretch_; !(options_.tolerance_world > least))
        throw Rejected(fmt::format("a tolerance of {} m is finer than the precision of the "
                                   "coordinates here; use more than {} m",
                                   number_text(options_.tolerance_world), number_text(least)));
}

double Refinement::bound(ComposedBounds& bounds, const auto& simplex, double target) const
{
    const double once = bounds(simplex, options_.method);
    const bool nearly = once > target && once <= 1.2 * target;
    return options_.method == BoundMethod::composed_net && nearly
               ? bounds(simplex, BoundMethod::composed_net_subdivided)
               : once;
}

void Refinement::bound_edges()
{
    std::vector<Edge>& edges = all_.edges();
    const std::size_t first = first_new_edge_;
    first_new_edge_ = edges.size();
    if (options_.rule == RefinementRule::thesis_four_split) return;
    const bool middles = options_.rule == RefinementRule::chua_neumann_midpoint;
    each_block(edges.size() - first, 256, [&](std::size_t begin, std::size_t end) {
        ComposedBounds bounds(cells_);
        for (std::size_t i = first + begin; i < first + end; ++i) {
            edges[i].bound = middles ? all_.middle_off(edges[i])
                                     : bound(bounds, all_.simplex(edges[i]), target(edges[i]));
        }
    });
}

bool Refinement::any_marked(const Triangle& triangle) const
{
    return std::ranges::any_of(triangle.edges, [&](Index e) { return all_.edges()[e].marked; });
}

void Refinement::bound_triangles(bool also_marked)
{
    if (options_.rule == RefinementRule::chua_neumann_midpoint) return;
    std::vector<Triangle>& triangles = all_.triangles();
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (triangles[i].bound == SharedTriangles::unknown &&
            (also_marked || !any_marked(triangles[i])))
            wanted.push_back(i);
    each_block(wanted.size(), 128, [&](std::size_t begin, std::size_t end) {
        ComposedBounds bounds(cells_);
        for (std::size_t i = begin; i < end; ++i) {
            Triangle& t = triangles[wanted[i]];
            t.bound = bound(bounds, all_.simplex(t), target(t));
        }
    });
}

bool Refinement::can_split(const Edge& edge) const
{
    const int depth = std::max(all_.points()[edge.a].depth, all_.points()[edge.b].depth);
    return depth < most_depth && target(edge) > 0 && all_.length_world(edge) > shortest_;
}

// Chooses the edge with the greatest bound; if no bound matters, the longest edge.
Index Refinement::worst_edge(const Triangle& triangle) const
{
    Index worst = SharedTriangles::none;
    const auto key = [&](Index e) {
        const Edge& edge = all_.edges()[e];
        return std::pair(edge.bound > 1e-2 * options_.tolerance_world ? edge.bound : 0,
                         all_.length_world(edge));
    };
    for (const Index e : triangle.edges)
        if (can_split(all_.edges()[e]) && (worst == SharedTriangles::none || key(e) > key(worst)))
            worst = e;
    return worst;
}

// Finds the longest edge of a needle if it is only just within the tolerance while another edge is
// not. If only the other one were split, the next needle on the longest edge could be off as well,
// and so on without end, because half of an S is further off its chord than all of it. So the
// longest edge is split, too.
Index Refinement::edge_of_needle(const Triangle& triangle) const
{
    constexpr double thin = 1.02;  // sum of the other two by the longest: a tenth as high
    constexpr double share = 0.25; // least length of the other edge, relative to the longest
    // Relative to the tolerance: a chord between two points of a curve is off it by at most twice
    // the error of the whole chord.
    constexpr double near = 0.45;
    std::array<double, 3> length;
    for (std::size_t i = 0; i < 3; ++i) { // undeformed, because a needle over a kink is bent
        const Edge& side = all_.edges()[triangle.edges[i]];
        length[i] = glm::length(scale_ * (all_.points()[side.a].uvw - all_.points()[side.b].uvw));
    }
    const auto longest =
        static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
    const Edge& edge = all_.edges()[triangle.edges[longest]];
    if (edge.marked || !(length[0] + length[1] + length[2] < (1 + thin) * length[longest]) ||
        !(edge.bound > near * target(edge)) || edge.bound == infinite)
        return SharedTriangles::none;
    for (std::size_t i = 0; i < 3; ++i)
        if (all_.edges()[triangle.edges[i]].marked && length[i] > share * length[longest])
            return triangle.edges[longest];
    return SharedTriangles::none;
}

void Refinement::mark()
{
    marked_ = false;
    std::vector<Edge>& edges = all_.edges();
    const auto mark_edge = [&](Index e) {
        if (e == SharedTriangles::none || !can_split(edges[e])) return;
        edges[e].marked = marked_ = true;
    };
    const std::size_t first = first_new_edge_;
    bound_edges();
    // An infinite bound stays infinite for the halves, so such edges are not split.
    for (std::size_t e = first; e < edges.size(); ++e)
        if (edges[e].bound > target(edges[e]) && edges[e].bound < infinite)
            mark_edge(static_cast<Index>(e));
    bound_triangles(false);
    for (const Triangle& t : all_.triangles()) {
        if (!(t.bound > target(t)) || t.bound == infinite) continue;
        if (options_.rule == RefinementRule::thesis_four_split)
            for (const Index e : t.edges) mark_edge(e);
        else if (!any_marked(t))
            mark_edge(worst_edge(t));
    }
    if (!marked_ || options_.rule != RefinementRule::edge_driven) return;
    for (const Triangle& t : all_.triangles())
        if (any_marked(t)) mark_edge(edge_of_needle(t));
}

// Keeps to the budget of triangles: a marked edge adds one triangle per triangle that it is a side
// of. If that is too many, only the worst edges are split.
void Refinement::keep_to_budget()
{
    std::vector<Edge>& edges = all_.edges();
    const std::vector<Triangle>& triangles = all_.triangles();
    std::vector<Index> uses(edges.size(), 0);
    std::size_t added = 0;
    for (const Triangle& t : triangles)
        for (const Index e : t.edges)
            if (edges[e].marked) {
                ++uses[e];
                ++added;
            }
    if (triangles.size() + added <= options_.budget) return;
    out_of_budget_ = true;
    std::vector<Index> marked;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (edges[e].marked) marked.push_back(static_cast<Index>(e));
    std::ranges::stable_sort(marked,
                             [&](Index x, Index y) { return edges[x].bound > edges[y].bound; });
    std::size_t left = options_.budget - std::min(options_.budget, triangles.size());
    marked_ = false;
    for (const Index e : marked) {
        const bool fits = uses[e] <= left;
        edges[e].marked = fits;
        marked_ |= fits;
        left = fits ? left - uses[e] : 0;
    }
}

void Refinement::choose_split_points()
{
    if (options_.split == SplitPoint::midpoint) return;
    std::vector<Edge>& edges = all_.edges();
    std::vector<Index> marked;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (edges[e].marked) marked.push_back(static_cast<Index>(e));
    each_block(marked.size(), 256, [&](std::size_t begin, std::size_t end) {
        ComposedBounds bounds(cells_);
        for (std::size_t i = begin; i < end; ++i) {
            Edge& edge = edges[marked[i]];
            const auto [by, there] = bounds.worst_part(all_.simplex(edge), options_.method);
            edge.t = static_cast<float>(split_point(by, there, options_.split));
        }
    });
}

void Refinement::split()
{
    for (mark(); marked_; mark()) {
        keep_to_budget();
        if (!marked_) break;
        const auto edges = static_cast<double>(all_.edges().size());
        done_ = 1 - static_cast<double>(std::ranges::count_if(all_.edges(), &Edge::marked)) / edges;
        choose_split_points();
        all_.split_marked();
        if (out_of_budget_) break;
    }
}

RefinementResult Refinement::result()
{
    bound_triangles(true);
    RefinementResult out;
    out.out_of_budget = out_of_budget_;
    for (const auto& point : all_.points()) {
        out.depth = std::max(out.depth, point.depth);
        out.rounding = std::max(out.rounding, rounding(point));
    }
    for (const Triangle& t : all_.triangles()) {
        if (t.part >= out.parts.size()) out.parts.resize(t.part + 1);
        RefinedPart& part = out.parts[t.part];
        const double bound = t.bound == SharedTriangles::unknown ? infinite : t.bound;
        part.bound = std::max(part.bound, bound + rounding(t));
        if (bound > target(t)) part.not_certified.push_back(static_cast<Index>(part.triangles));
        const auto [a, b, c] = all_.simplex(t).by_first;
        for (const Index v : t.vertices) {
            if (v >= part.bound_at.size()) part.bound_at.resize(v + 1);
            part.bound_at[v] = std::max(part.bound_at[v], static_cast<float>(bound + rounding(t)));
        }
        part.degenerate += glm::cross(b.uvw - a.uvw, c.uvw - a.uvw) == glm::dvec3(0);
        ++part.triangles;
    }
    out.parts.resize(all_.part_count());
    for (std::size_t p = 0; p < out.parts.size(); ++p) {
        out.parts[p].mesh = all_.mesh(p);
        out.parts[p].born = all_.born(p);
        out.parts[p].bound_at.resize(out.parts[p].mesh->vertex_count()); // some have no face
        out.parts[p].triangles_before = all_.triangles_before(p);
        out.bound = std::max(out.bound, out.parts[p].bound);
    }
    return out;
}

} // namespace

std::size_t RefinementResult::triangles() const
{
    std::size_t sum = 0;
    for (const RefinedPart& part : parts) sum += part.triangles;
    return sum;
}

std::size_t RefinementResult::not_certified() const
{
    std::size_t sum = 0;
    for (const RefinedPart& part : parts) sum += part.not_certified.size();
    return sum;
}

RefinementResult refine(const std::vector<RefinePart>& parts, const Lattice& lattice,
                        const RefineOptions& options, const Progress& progress,
                        const std::vector<NextVolume>& next)
{
    if (!(options.tolerance_world > 0) || !std::isfinite(options.tolerance_world))
        throw Rejected("the tolerance must be above 0 m");
    Refinement refinement(parts, lattice, options, progress, next);
    refinement.split();
    return refinement.result();
}

RefinementResult bounded(const std::vector<RefinePart>& parts, const Lattice& lattice,
                         const RefineOptions& options, const Progress& progress,
                         const std::vector<NextVolume>& next)
{
    return Refinement(parts, lattice, options, progress, next).result();
}

} // namespace trivar
