// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/field.h"

#include "core/base/parallel.h"
#include "core/incise/slit_curve.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivar {
namespace {

// The depth below a cut to which the skin gives way: shares of its reach, and of the body's
// thickness.
constexpr double reach_of_room = 0.5, thickness_of_room = 0.7;
constexpr double room_smoothed_over = 0.25; // of the reach
constexpr double wrong_side = -0.2;         // cosine: a front that came round the end of a cut

// A Passage is the way of a piece through a node: which sectors lie left (1) and right (-1) of it;
// 0: it ends.
struct Passage {
    std::uint32_t node;
    double s;
    std::vector<int> side; // by sector
};

// The passages of each piece, by node.
std::vector<std::vector<Passage>> passages_of(const SlitGraph& graph, std::size_t pieces)
{
    constexpr std::size_t nowhere = ~std::size_t{0};
    std::vector<std::vector<Passage>> out(pieces);
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
        const SlitNode& node = graph.nodes[n];
        struct Ways {
            std::size_t in = nowhere, out = nowhere;
            double s = 0;
        };
        std::map<std::uint32_t, Ways> ways; // by piece
        for (std::size_t i = 0; i < node.edges.size(); ++i) {
            const SlitEdge& edge = graph.edges[node.edges[i]];
            const bool at_a = edge.starts_at(node.point);
            for (const SlitEdge::Pass& pass : edge.passes) {
                Ways& w = ways[pass.piece];
                std::size_t& way = pass.forward == at_a ? w.out : w.in;
                if (way != nowhere) continue;
                way = i;
                w.s = at_a ? pass.s_a : pass.s_b;
            }
        }
        const std::size_t count = node.edges.size();
        for (const auto& [piece, w] : ways) {
            Passage passage{n, w.s, std::vector<int>(count, 0)};
            if (w.in != nowhere && w.out != nowhere) {
                for (std::size_t i = w.out; i != w.in; i = (i + 1) % count) passage.side[i] = 1;
                for (std::size_t i = w.in; i != w.out; i = (i + 1) % count) passage.side[i] = -1;
            }
            out[piece].push_back(std::move(passage));
        }
    }
    return out;
}

// The neighbours of the patch's points along edges of its pieces.
struct Neighbours {
    KeyNumbers number;
    std::vector<std::uint32_t> begin, of;

    explicit Neighbours(const std::vector<SkinTriangle>& triangles)
    {
        for (const SkinTriangle& t : triangles)
            for (const std::uint32_t p : t.points) number.number(p);
        begin.assign(number.size() + 1, 0);
        for (const SkinTriangle& t : triangles)
            for (const std::uint32_t p : t.points) begin[number.find(p) + 1] += 2;
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        of.resize(begin.back());
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (const SkinTriangle& t : triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                std::uint32_t& at = next[number.find(t.points[k])];
                of[at++] = t.points[(k + 1) % 3];
                of[at++] = t.points[(k + 2) % 3];
            }
    }
};

// Returns the share of the field at a depth, given as a share of the floor's.
double share_at_depth(const Incision& incision, double depth)
{
    const double at_floor = incision.floor == Incision::Floor::u ? incision.floor_width : 0;
    if (depth <= 1) return at_floor + (1 - at_floor) * (1 - depth);
    return std::max(0.0, at_floor * (2 - depth));
}

// Returns the share of a bevel at a share of its depth.
double share_of_bevel(const Incision& incision, double depth)
{
    const double round = 1 - std::sqrt(std::max(0.0, 1 - (1 - depth) * (1 - depth)));
    return (1 - incision.roundness) * (1 - depth) + incision.roundness * round;
}

struct FieldOfPiece {
    const SlitDrawing& drawing;
    const SlitPatch& patch;
    const SlitGraph& graph;
    const Neighbours& neighbours;
    const std::vector<Passage>& passages;
    const SlitRun& run;
    const SlitCurve& curve;
    const SlitPiece& piece;
    const Incision& incision;
    double reach;
    std::vector<double> room = {}; // by point of the run: how far below the skin it gives way

    // At a node that the piece does not pass.
    struct AtNode {
        std::uint32_t node;
        double s;
        glm::dvec3 way;
    };
    std::vector<SlitTerm> terms = {};
    std::vector<AtNode> others = {};

    void operator()(const SlitWalls& walls, double step)
    {
        flood();
        const auto first_made = static_cast<std::uint32_t>(drawing.point_count());
        std::map<std::uint32_t, int> sides; // of the vertices of a node; 0: of both
        const auto depth_of = [&](std::uint32_t vertex) {
            return vertex < first_made ? 0 : walls.made[vertex - first_made].depth * step;
        };
        for (const Passage& passage : passages) {
            const SlitNode& node = graph.nodes[passage.node];
            sides.clear();
            for (std::size_t i = 0; i < node.corners.size(); ++i) {
                const int side = passage.side[i % node.edges.size()];
                const auto [found, fresh] = sides.emplace(node.corners[i], side);
                if (!fresh && found->second != side) found->second = 0;
            }
            for (const auto& [vertex, side] : sides)
                if (side != 0)
                    add(vertex, double(side) * curve.left(passage.s), passage.s, depth_of(vertex));
        }
        for (const AtNode& at : others) {
            sides.clear();
            for (const std::uint32_t vertex : graph.nodes[at.node].corners)
                sides.emplace(vertex, 0);
            for (const auto& [vertex, unused] : sides) add(vertex, at.way, at.s, depth_of(vertex));
        }
    }

private:
    // The way of the field at p, on a side of the cut, of length 1 at the cut: less with the
    // distance, and none as far below it as the other side of a thin body. It turns with the skin,
    // whose tangents turn by twice the angle of a chord.
    glm::dvec3 way_at(const glm::dvec3& p, const SlitCurve::Foot& foot, int side) const
    {
        const auto bump = [](double x) { return x < 1 ? (1 - x * x) * (1 - x * x) : 0; };
        const double near = bump(foot.distance / reach);
        if (near == 0) return glm::dvec3(0);
        const glm::dvec3 up = curve.up(foot.s, foot.segment),
                         left = double(side) * curve.left(foot.s, foot.segment);
        const glm::dvec3 off = p - curve.point(foot.s, foot.segment);
        const double below = -glm::dot(off, up);
        const double most =
            glm::mix(room[foot.segment], room[foot.segment + 1], curve.share(foot.s, foot.segment));
        const double faded = near * bump(std::max(0.0, 2 * below / most - 1));
        const glm::dvec3 level = off + below * up;
        const double beside = glm::length(level);
        if (!(faded > 0) || !(beside > 0)) return faded * left;
        const double turn = std::atan2(below, std::hypot(beside, run.width));
        const double across = glm::dot(left, level) / beside;
        return faded *
               (left + across * ((std::cos(turn) - 1) / beside * level - std::sin(turn) * up));
    }
    double opening(double s) const
    {
        return run.value(incision.opening_profile, s) * piece.weight(s);
    }
    // The distance by which the rim is set back beyond the width.
    double bevel(double s) const
    {
        if (!(incision.bevel > 0)) return 0;
        return run.kind == SlitRun::Kind::far_side ? far_bevel(incision, depth_at(run, s))
                                                   : bevel_at(run, incision, s);
    }
    void add(std::uint32_t vertex, const glm::dvec3& way, double s, double depth)
    {
        const double floor = depth_at(run, s);
        const double below = !run.has_floor() ? 1
                             : floor > 0      ? share_at_depth(incision, depth / floor)
                                              : depth == 0;
        double amount = 0.5 * run.width * opening(s) * below;
        if (const double set_back = bevel(s); depth < set_back)
            amount += set_back * opening(s) * share_of_bevel(incision, depth / set_back);
        if (!(amount > 0)) return;
        const double under = floor > 0 ? std::min(1.0, depth / floor) : 0;
        terms.push_back({vertex, run.incision, static_cast<float>(run.share(s)),
                         static_cast<float>(under), glm::vec3(amount * way)});
    }

    void flood()
    {
        const SlitSkin& skin = drawing.skin();
        std::size_t first = 0, last = curve.segment_count() - 1;
        while (first < last && curve.s(first + 1) <= piece.begin) ++first;
        while (last > first && curve.s(last) >= piece.end) --last;
        KeyNumbers seen;
        struct Open {
            std::uint32_t point;
            std::size_t segment;
            int side;
        };
        std::vector<Open> open;
        const double slack = 1e-12 * run.length;
        const auto accept = [&](std::uint32_t point, std::size_t near, int side, bool at_slit) {
            if (seen.contains(point)) return;
            const glm::dvec3 p = drawing.position(point);
            const SlitCurve::Foot foot = curve.foot(p, near, first, last);
            const glm::dvec3 way = way_at(p, foot, side);
            if (!(way != glm::dvec3(0))) return;
            if (!at_slit && foot.s > piece.begin + slack && foot.s < piece.end - slack &&
                glm::dot(curve.left(foot.s, foot.segment), p - curve.point(foot.s, foot.segment)) *
                        side <
                    wrong_side * foot.distance)
                return;
            seen.number(point);
            open.push_back({point, foot.segment, side});
            const std::uint32_t node = graph.node_of_point.find(point);
            if (node != KeyNumbers::none) {
                others.push_back({node, foot.s, way});
                return;
            }
            const double amount = (0.5 * run.width + bevel(foot.s)) * opening(foot.s);
            if (amount != 0)
                terms.push_back({point, run.incision, static_cast<float>(run.share(foot.s)), 0,
                                 glm::vec3(amount * way)});
        };
        for (const Passage& passage : passages) seen.number(graph.nodes[passage.node].point);
        for (const Passage& passage : passages) start_at(passage, first, last, accept);
        for (std::size_t i = 0; i < open.size(); ++i) {
            const Open at = open[i];
            const std::uint32_t local = neighbours.number.find(at.point);
            if (local != KeyNumbers::none)
                for (std::uint32_t k = neighbours.begin[local]; k < neighbours.begin[local + 1];
                     ++k)
                    accept(neighbours.of[k], at.segment, at.side, false);
            if (at.point >= skin.point_count()) continue;
            // All round a point the end of a triangle is the beginning of the next one
            const bool all_round =
                local == KeyNumbers::none && skin.soundness(at.point) == SlitSkin::Soundness::sound;
            skin.around(at.point, [&](std::uint32_t side) {
                if (local != KeyNumbers::none && patch.replaces(side / 3)) return;
                accept(skin.to(side), at.segment, at.side, false);
                if (!all_round)
                    accept(skin.from(SlitSkin::previous(side)), at.segment, at.side, false);
            });
        }
    }

    // The points next to a node, each in the sector in which it lies; those on the slit itself
    // belong to no side.
    void start_at(const Passage& passage, std::size_t first, std::size_t last, const auto& accept)
    {
        const SlitNode& node = graph.nodes[passage.node];
        const std::size_t count = node.edges.size();
        const std::size_t near = std::clamp(curve.segment_at(passage.s), first, last);
        for (std::size_t i = 0; i < count; ++i) {
            if (passage.side[i] == 0) continue;
            const auto end_of = [&](std::size_t k) {
                const SlitEdge& edge = graph.edges[node.edges[k]];
                return edge.starts_at(node.point) ? edge.b : edge.a;
            };
            const auto divides = [&](std::size_t k) {
                return passage.side[k] != passage.side[(k + count - 1) % count];
            };
            std::uint32_t to = end_of(i);
            const std::uint32_t stop = end_of((i + 1) % count);
            if (!divides(i)) accept(to, near, passage.side[i], true);
            do {
                const std::uint32_t t = patch.triangle_of_side.find(pair_key(node.point, to));
                const auto& p = patch.triangles[t].points;
                to = p[0] == node.point ? p[2] : p[1] == node.point ? p[0] : p[1];
                if (to != stop || !divides((i + 1) % count))
                    accept(to, near, passage.side[i], true);
            } while (to != stop);
        }
    }
};

} // namespace

std::vector<SlitTerm> field_of(const SlitDrawing& drawing, const SlitPatch& patch,
                               const SlitGraph& graph, const SlitWalls& walls,
                               const std::vector<SlitRun>& runs,
                               const std::vector<SlitPiece>& pieces,
                               std::span<const Incision> incisions, const Inward& inward,
                               double step)
{
    std::vector<SlitCurve> curves;
    for (const SlitRun& run : runs) curves.emplace_back(run, drawing, inward);
    const std::vector<std::vector<Passage>> passages = passages_of(graph, pieces.size());
    const Neighbours neighbours(patch.triangles);
    std::vector<std::vector<SlitTerm>> terms(pieces.size());
    parallel_blocks(pieces.size(), 1, [&](std::size_t p, std::size_t) {
        const SlitRun& run = runs[pieces[p].run];
        FieldOfPiece field{drawing,
                           patch,
                           graph,
                           neighbours,
                           passages[p],
                           run,
                           curves[pieces[p].run],
                           pieces[p],
                           incisions[run.incision],
                           reach_of(incisions[run.incision], run.length)};
        for (const SlitRun::At& at : run.at)
            field.room.push_back(
                std::min(reach_of_room * field.reach, thickness_of_room * at.thickness));
        smooth_room(run, room_smoothed_over * field.reach, field.room);
        field(walls, step);
        terms[p] = std::move(field.terms);
    });
    std::vector<SlitTerm> all;
    for (const std::vector<SlitTerm>& each : terms) all.insert(all.end(), each.begin(), each.end());
    return all;
}

} // namespace trivar
