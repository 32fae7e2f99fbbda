// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incise.h"

#include "core/base/finite.h"
#include "core/incise/folds.h"
#include "core/incise/guard.h"
#include "core/incise/incised_mesh.h"
#include "core/incise/left_out.h"
#include "core/incise/slit_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr double shallower_at_rest = 0.6, shallower_when_open = 0.7; // shares
// Times that depths give way while all is shut, and for the opening; and that folds are halved.
constexpr int most_at_rest = 12, most_when_open = 4, most_halvings = 6;
constexpr int near_the_place = 8;   // so often where walls meet alone, then all along the incision
constexpr double worth_it = 0.7;    // of what an opening lacks, for less depth
constexpr double much_lacks = 0.05; // of openings: for less nothing else is tried
constexpr double much_narrowed = 0.6, rung = 0.70710678; // shares of widths
constexpr int most_rungs = 20;                           // down to a thousandth of the length
constexpr std::size_t triangles_made_in_a_look = 4;      // for what one look costs
constexpr std::size_t most_looks = 150'000;              // a second or two of one processor
constexpr double edges_of_dent_in_depth = 1.5;
constexpr const char* no_room = "the body has no room for its depth there";
constexpr const char* no_way = "its walls would meet others on their way through";
constexpr const char* no_piece = "it cuts out no piece, as it is no loop through the body";
constexpr const char* one_piece =
    "its loop cuts out no piece, as both sides hang together elsewhere";
constexpr double deepest_through = 1000; // of the deepest floor, down to which a cut goes through

// Returns the greatest depth of all floors, or of the cuts through the body if no cut has a floor.
double deepest_of(const std::vector<SlitRun>& runs, std::span<const Incision> incisions)
{
    double deepest = 0, last_rows = 0;
    for (const SlitRun& run : runs) {
        if (run.has_floor()) deepest = std::max(deepest, incisions[run.incision].depth);
        if (run.kind != SlitRun::Kind::through) continue;
        for (const SlitRun::At& at : run.at) last_rows = std::max(last_rows, at.depth);
    }
    return std::max(deepest > 0 ? deepest : last_rows, last_rows / deepest_through);
}

// A Made is the result of one attempt to cut.
struct Made {
    SlitShape shape;
    std::vector<LeftOutPieces::Kept> kept;
    std::vector<Admission> admitted = {};
    double lacks = 0; // of openings, in all
};

// An Effort is the cost of attempts so far, in tested triangles. Improvements are tried only while
// it is small, so that a scribble over itself is cut as soon as a plain stroke.
struct Effort {
    const Progress& progress;
    std::size_t looks = 0;
    bool may_try_more() const { return looks < most_looks; }
};

class Cutter {
public:
    Cutter(SlitLayout& layout, std::span<const Incision> all, const InciseOptions& options,
           Effort& effort)
        : layout_(layout),
          all_(all),
          options_(options),
          effort_(effort),
          pieces_(pieces_of(layout.runs, layout.drawing)),
          depths_(all.size())
    {
        const double deepest = deepest_of(layout.runs, all);
        step_ = deepest / depth_steps;
        for (std::size_t i = 0; i + 1 < options.layers.size(); ++i)
            borders_.push_back(static_cast<int>(std::lround(
                std::min(deepest_through, options.layers[i].depth / deepest) * depth_steps)));
        std::ranges::sort(borders_);
        fill();
    }
    const std::vector<int>& borders() const { return borders_; }

    // The best of some attempts. None: nothing has room, or cuts cannot go through the body, which
    // have a shortfall then.
    std::unique_ptr<Made> operator()(Shortfalls& shortfalls)
    {
        std::unique_ptr<Made> made = attempt();
        if (!options_.guarded) return made;
        std::optional<SlitGuard> guard;
        for (int turn = 0; made; ++turn, made = attempt()) {
            guard.emplace(made->shape, all_);
            const std::vector<SlitGuard::Walls> walls = guard->walls_in_the_way();
            if (walls.empty()) break;
            if (blocks_a_way(made->shape, walls, shortfalls)) return {};
            if (turn == most_at_rest) {
                for (Admission& each : made->admitted)
                    for (Admitted* of : {&each.with_others, &each.alone})
                        of->opening.narrow(0.5, 0, infinite);
                return made;
            }
            make_shallower(made->shape, walls, turn < near_the_place);
        }
        if (!made || guard->admits_all()) return made;
        std::unique_ptr<Made> other = with_halved_folds(*made);
        if (other && SlitGuard(other->shape, all_).admits_all()) return other;
        admit(*made, *guard, infinite);
        if (other && made->lacks >= much_lacks) take_better(made, other);
        for (int turn = 0;
             turn < most_when_open && made->lacks > much_lacks && effort_.may_try_more(); ++turn) {
            for (std::size_t k = 0; k < all_.size(); ++k)
                depths_[k].lower_where_narrowed(made->admitted[k].with_others.opening,
                                                shallower_when_open);
            other = attempt();
            if (!other) break;
            take_better(made, other);
        }
        if (std::ranges::any_of(made->admitted,
                                [](const Admission& each) { return !each.held_by.empty(); }))
            SlitGuard(made->shape, all_).find_alone(made->admitted);
        return made;
    }

private:
    void fill()
    {
        pieces_of_skin_.clear();
        for (const std::uint32_t t : layout_.drawing.touched())
            for (const SkinTriangle& piece : filled(layout_.drawing, t))
                pieces_of_skin_.push_back(piece);
    }

    // Tells how far incisions may open. False: they lack `most` or more.
    bool admit(Made& made, const SlitGuard& guard, double most) const
    {
        std::optional<std::vector<Admission>> admitted = guard.admitted(most);
        effort_.looks += guard.looks();
        if (!admitted) return false;
        made.admitted = *std::move(admitted);
        made.lacks = guard.lack(made.admitted);
        return true;
    }

    // Takes another attempt where it lacks less by so much that it is worth it.
    void take_better(std::unique_ptr<Made>& made, std::unique_ptr<Made>& other) const
    {
        const SlitGuard guard(other->shape, all_);
        if (guard.walls_in_the_way().empty() && admit(*other, guard, worth_it * made->lacks))
            made = std::move(other);
    }

    // With pieces of skin that can follow the field where those of another attempt turn over; of
    // some attempts that with the fewest that do. None: there is no such piece.
    std::unique_ptr<Made> with_halved_folds(const Made& before)
    {
        std::unique_ptr<Made> best, last;
        std::size_t fewest = ~std::size_t{0};
        std::vector<LatticePoint> points = points_against_folds(before.shape);
        for (int turn = 0; turn < most_halvings && !points.empty() && effort_.may_try_more();
             ++turn) {
            for (const LatticePoint& each : points) layout_.drawing.add(each);
            fill();
            last = attempt();
            if (!last) break;
            points = points_against_folds(last->shape);
            if (points.size() / 2 > fewest) break; // it finds no end
            if (points.size() >= fewest) continue;
            fewest = points.size();
            best = std::move(last);
        }
        return best;
    }

    std::unique_ptr<Made> attempt() const
    {
        report(effort_.progress, std::min(1.0, static_cast<double>(effort_.looks) / most_looks),
               "incise");
        const SlitDrawing& drawing = layout_.drawing;
        const Inward& inward = *layout_.inward;
        SlitShape shape{drawing, drawing.point_count(),
                        inward,  *layout_.columns,
                        step_,   layout_.runs,
                        pieces_, {},
                        {},      {},
                        {}};
        set_depths(shape.runs, drawing, inward, *layout_.columns, all_, depths_);
        shape.graph = slits_of(shape.runs, pieces_, all_, drawing, inward, step_,
                               depth_steps / std::max(1, options_.rows) / 2);
        if (shape.graph.edges.empty()) return {};
        shape.patch = patch_of(drawing, pieces_of_skin_, shape.graph);
        shape.walls = walls_of(drawing, shape.patch, shape.graph, options_.rows, borders_,
                               shape.runs, layout_.throughs);
        shape.terms = field_of(drawing, shape.patch, shape.graph, shape.walls, shape.runs, pieces_,
                               all_, inward, step_);
        effort_.looks +=
            (shape.walls.walls.size() + shape.walls.skin.size()) / triangles_made_in_a_look;
        LeftOutPieces left_out = left_out_pieces(shape, all_);
        shape.left_out = std::move(left_out.pieces);
        return std::make_unique<Made>(
            Made{std::move(shape), std::move(left_out.kept), std::vector<Admission>(all_.size())});
    }

    // The first incision that passes a wall, whose it is.
    std::uint32_t owner(const SlitShape& shape, std::uint32_t wall) const
    {
        std::uint32_t first = ~0u;
        visit_runs(shape, wall,
                   [&](const SlitRun& run, double) { first = std::min(first, run.incision); });
        return first;
    }
    // Calls visit(run, s) with the runs whose wall it is.
    void visit_runs(const SlitShape& shape, std::uint32_t wall, const auto& visit) const
    {
        const SlitEdge& edge = shape.graph.edges[shape.walls.walls[wall].corners[0].edge];
        for (const SlitEdge::Pass& pass : edge.passes)
            visit(shape.runs[pieces_[pass.piece].run], (pass.s_a + pass.s_b) / 2);
    }

    // Whether walls through the body are among those that pierce others.
    bool blocks_a_way(const SlitShape& shape, const std::vector<SlitGuard::Walls>& walls,
                      Shortfalls& shortfalls) const
    {
        bool any = false;
        for (const auto& [a, b] : walls)
            for (const std::uint32_t wall : {a, b})
                visit_runs(shape, wall, [&](const SlitRun& run, double) {
                    if (run.has_floor()) return;
                    shortfalls[run.incision] = no_way;
                    any = true;
                });
        return any;
    }

    // Makes one of two walls that pierce each other shallower: that of the later incision.
    void make_shallower(const SlitShape& shape, const std::vector<SlitGuard::Walls>& walls,
                        bool near_alone)
    {
        const std::vector<Narrowing> before = depths_;
        const auto lower = [&](const SlitRun& run, double s) {
            const double x = run.share(s);
            const double around =
                std::max(edges_of_dent_in_depth * layout_.drawing.skin().usual_edge(),
                         all_[run.incision].depth);
            depths_[run.incision].narrow(x, shallower_at_rest * before[run.incision].at(x),
                                         near_alone ? run.as_share(around) : infinite,
                                         run.goes_round());
        };
        for (const auto& [a, b] : walls) {
            const std::uint32_t of_a = owner(shape, a), of_b = owner(shape, b);
            if (of_a >= of_b) visit_runs(shape, a, lower);
            if (of_b >= of_a && b != a) visit_runs(shape, b, lower);
        }
    }

    SlitLayout& layout_;
    std::span<const Incision> all_;
    const InciseOptions& options_;
    Effort& effort_;
    std::vector<SlitPiece> pieces_;
    std::vector<Narrowing> depths_; // by incision
    double step_ = 0;
    std::vector<int> borders_;
    std::vector<SkinTriangle> pieces_of_skin_;
};

// Returns how far a part of an incision opens where it is widest, as a share of the width asked
// for.
double widest_of(const SlitRun& run, const Admitted& admitted, const Incision& asked)
{
    return (asked.width > 0 ? run.width / asked.width : 1) *
           admitted.opening.widest(asked.opening_profile, run.from, run.to);
}

void tell_outcomes(IncisedMesh& out, const Made& made, std::span<const Incision> all,
                   const Shortfalls& shortfalls)
{
    const SlitShape& shape = made.shape;
    for (const SlitRun& run : shape.runs) {
        IncisedMesh::Outcome& outcome = out.outcomes[run.incision];
        for (const SlitRun::At& at : run.at) outcome.depth = std::max(outcome.depth, at.depth);
        if (run.kind == SlitRun::Kind::far_side) continue;
        outcome.length += run.length;
        outcome.least_depth = std::min(outcome.least_depth, run.least_depth);
        const Incision& asked = all[run.incision];
        const Admission& of = made.admitted[run.incision];
        outcome.widest = std::max(outcome.widest, widest_of(run, of.with_others, asked));
        outcome.widest_alone = std::max(outcome.widest_alone, widest_of(run, of.alone, asked));
        outcome.held_by = of.held_by;
        outcome.least = of.with_others.opening.least();
        outcome.least_below = of.with_others.below.least();
    }
    for (const LeftOutPieces::Kept& kept : made.kept)
        out.outcomes[kept.incision].shortfall = kept.loop ? one_piece : no_piece;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (!shortfalls[k].empty()) out.outcomes[k].shortfall = shortfalls[k];
    std::vector<char> has_walls(all.size(), 0);
    for (const SlitEdge& edge : shape.graph.edges)
        for (const SlitEdge::Pass& pass : edge.passes)
            has_walls[shape.runs[shape.pieces[pass.piece].run].incision] = 1;
    for (const SlitRun& run : shape.runs)
        if (!has_walls[run.incision]) out.outcomes[run.incision].refusal = no_room;
}

// The cuts of a layout, or none where one more of them cannot go through the body.
std::optional<IncisedMesh> cut(SlitLayout& layout, std::span<const Incision> all,
                               const InciseOptions& options,
                               std::vector<IncisedMesh::Outcome> outcomes, Shortfalls& shortfalls,
                               RefPool<Mesh>& pool, Effort& effort)
{
    IncisedMesh out;
    out.original = out.rest = layout.drawing.skin().mesh();
    out.outcomes = std::move(outcomes);
    Cutter cutter(layout, all, options, effort);
    const Shortfalls before = shortfalls;
    std::unique_ptr<Made> made = cutter(shortfalls);
    if (shortfalls != before) return std::nullopt;
    if (!made) {
        for (const SlitRun& run : layout.runs) out.outcomes[run.incision].refusal = no_room;
        return out;
    }
    for (SlitTerm& term : made->shape.terms) {
        const Admission& of = made->admitted[term.incision];
        const double share{term.share}, below{term.below};
        const double held = of.with_others.at(share, below), alone = of.alone.at(share, below);
        term.held = alone > 0 ? static_cast<float>(held / alone) : 1;
        term.move *= static_cast<float>(alone > 0 ? alone : held);
    }
    tell_outcomes(out, *made, all, shortfalls);
    for (const ThroughSlit& each : layout.throughs)
        out.outcomes[layout.runs[each.near].incision].crossed_through +=
            static_cast<int>(each.crossings.size());
    make_rest(out, made->shape, all, cutter.borders(), options.layers, pool);
    return out;
}

IncisedMesh as_asked(const SlitSkin& skin, std::span<const Incision> all,
                     const InciseOptions& options, RefPool<Mesh>& made, Effort& effort)
{
    Shortfalls shortfalls(all.size());
    for (;;) { // ends as every turn without a result adds a shortfall
        IncisedMesh none;
        none.original = none.rest = skin.mesh();
        none.outcomes.resize(all.size());
        const std::unique_ptr<SlitLayout> layout =
            laid_out(skin, all, options.reach, options.rows, none.outcomes, shortfalls);
        if (!layout) continue;
        if (layout->runs.empty()) return none;
        if (std::optional<IncisedMesh> whole =
                cut(*layout, all, options, none.outcomes, shortfalls, made, effort))
            return *std::move(whole);
    }
}

} // namespace

IncisedMesh incise(const SlitSkin& skin, std::span<const Incision> all,
                   const InciseOptions& options)
{
    RefPool<Mesh> none;
    return incise(skin, all, options, none);
}

IncisedMesh incise(const SlitSkin& skin, std::span<const Incision> asked,
                   const InciseOptions& options, RefPool<Mesh>& made, const Progress& progress)
{
    Effort effort{progress};
    std::vector<Incision> all(asked.begin(), asked.end());
    IncisedMesh best = as_asked(skin, all, options, made, effort);
    const auto gap = [&](const IncisedMesh& of, std::size_t k) {
        return of.outcomes[k].widest * all[k].width;
    };
    // One that is much narrowed may be wider where less is asked for: widths of a ladder are tried,
    // so that it never opens less where more is asked for
    for (std::size_t k = 0; k < all.size(); ++k) {
        const double widest = width_of(all[k], best.outcomes[k].length);
        if (!(gap(best, k) < much_narrowed * widest)) continue;
        Incision any = all[k];
        any.width = infinite;
        double width = width_of(any, best.outcomes[k].length);
        for (int turn = 0; turn < most_rungs && width > gap(best, k) && effort.may_try_more();
             ++turn, width *= rung) {
            if (!(width < widest)) continue;
            const double before = gap(best, k), asked_before = all[k].width;
            all[k].width = width;
            IncisedMesh other = as_asked(skin, all, options, made, effort);
            if (gap(other, k) > before)
                best = std::move(other);
            else
                all[k].width = asked_before;
        }
    }
    for (std::size_t k = 0; k < all.size(); ++k)
        for (double IncisedMesh::Outcome::*of :
             {&IncisedMesh::Outcome::widest, &IncisedMesh::Outcome::widest_alone})
            if (all[k].width != asked[k].width)
                best.outcomes[k].*of *= all[k].width / asked[k].width;
    return best;
}

} // namespace trivar
