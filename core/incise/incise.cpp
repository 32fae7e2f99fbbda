// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incise.h"

#include "core/incise/cut_layout.h"
#include "core/incise/guard.h"
#include "core/incise/incised_mesh.h"
#include "core/incise/left_out.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double shallower_at_rest = 0.6, shallower_when_open = 0.5;
constexpr int most_attempts = 12, most_open_attempts = 4;
constexpr const char* no_room = "the body has no room for its depth there";
constexpr const char* no_way = "its walls would meet others on their way through";
constexpr const char* no_piece = "it cuts out no piece, as it is no loop through the body";
constexpr const char* one_piece =
    "its loop cuts out no piece, as both sides hang together elsewhere";
constexpr double deepest_through = 1000; // of the deepest floor, down to which a cut goes through
constexpr double hardly_open = 0.02;     // share of the width

// Of all floors; without one, of the cuts through the body.
double deepest_of(const std::vector<CutRun>& runs, std::span<const Incision> incisions)
{
    double deepest = 0, last_rows = 0;
    for (const CutRun& run : runs) {
        if (run.has_floor()) deepest = std::max(deepest, incisions[run.incision].depth);
        if (run.kind != CutRun::Kind::through) continue;
        for (const CutRun::At& at : run.at) last_rows = std::max(last_rows, at.depth);
    }
    return std::max(deepest > 0 ? deepest : last_rows, last_rows / deepest_through);
}

// The cuts of a layout, or none where one more of them cannot go through the body.
std::optional<IncisedMesh> cut(const CutLayout& layout, std::span<const Incision> all,
                               const InciseOptions& options,
                               std::vector<IncisedMesh::Outcome> outcomes, Shortfalls& shortfalls,
                               Lender<Mesh>& made)
{
    IncisedMesh out;
    const CutDrawing& drawing = layout.drawing;
    out.original = out.rest = drawing.skin().mesh();
    out.outcomes = std::move(outcomes);
    const std::vector<CutRun>& runs = layout.runs;
    std::vector<SkinTriangle> pieces_of_skin;
    for (const std::uint32_t t : drawing.touched())
        for (const SkinTriangle& piece : filled(drawing, t)) pieces_of_skin.push_back(piece);
    const Inward& inward = *layout.inward;
    const std::vector<CutPiece> pieces = pieces_of(runs, drawing);

    const double deepest = deepest_of(runs, all);
    const double step = deepest / depth_steps;
    std::vector<int> borders;
    for (std::size_t i = 0; i + 1 < options.layers.size(); ++i)
        borders.push_back(static_cast<int>(std::lround(
            std::min(deepest_through, options.layers[i].depth / deepest) * depth_steps)));
    std::ranges::sort(borders);

    double scale = 1;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        CutShape shape{drawing, inward, *layout.columns, step, runs, pieces, {}, {}, {}, {}};
        set_depths(shape.runs, drawing, inward, *layout.columns, all, scale);
        shape.graph = slits_of(shape.runs, pieces, all, drawing, inward, step,
                               depth_steps / std::max(1, options.rows) / 2);
        if (shape.graph.edges.empty()) {
            for (const CutRun& run : runs) out.outcomes[run.incision].refusal = no_room;
            return out;
        }
        shape.patch = patch_of(drawing, pieces_of_skin, shape.graph);
        shape.walls = walls_of(drawing, shape.patch, shape.graph, options.rows, borders, shape.runs,
                               layout.throughs);
        shape.terms = field_of(drawing, shape.patch, shape.graph, shape.walls, shape.runs, pieces,
                               all, inward, step);
        LeftOutPieces left_out = left_out_pieces(shape, all);
        shape.left_out = std::move(left_out.pieces);
        std::vector<Admitted> admitted(all.size());
        if (options.guarded) {
            const bool last = attempt + 1 == most_attempts;
            std::optional<std::vector<Admitted>> found = admissible_openings(shape, all);
            if (!found && !layout.throughs.empty()) {
                const std::vector<std::uint32_t> in_the_way = piercing_on_their_way(shape);
                for (const std::uint32_t k : in_the_way) shortfalls[k] = no_way;
                if (!in_the_way.empty()) return std::nullopt;
            }
            if (found)
                admitted = std::move(*found);
            else if (last)
                for (Admitted& each : admitted) each.opening.narrow(0.5, 0, infinite);
            else {
                scale *= shallower_at_rest;
                continue;
            }
            double widest = 0;
            for (const CutRun& run : runs)
                widest = std::max(widest, admitted[run.incision].opening.widest(
                                              all[run.incision].opening_profile));
            if (widest < hardly_open && attempt < most_open_attempts) {
                scale *= shallower_when_open;
                continue;
            }
        }
        for (CutTerm& term : shape.terms)
            term.move *= static_cast<float>(
                admitted[term.incision].at(double{term.share}, double{term.below}));
        for (const CutRun& run : shape.runs) {
            IncisedMesh::Outcome& outcome = out.outcomes[run.incision];
            if (run.kind == CutRun::Kind::far_side) {
                for (const CutRun::At& at : run.at)
                    outcome.depth = std::max(outcome.depth, at.depth);
                continue;
            }
            outcome.length = run.length;
            for (const CutRun::At& at : run.at) outcome.depth = std::max(outcome.depth, at.depth);
            const Admitted& of = admitted[run.incision];
            outcome.widest = of.opening.widest(all[run.incision].opening_profile);
            outcome.least = of.opening.least();
            outcome.least_below = of.below.least();
        }
        for (const LeftOutPieces::Kept& kept : left_out.kept)
            out.outcomes[kept.incision].shortfall = kept.loop ? one_piece : no_piece;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (!shortfalls[k].empty()) out.outcomes[k].shortfall = shortfalls[k];
        std::vector<char> has_walls(all.size(), 0);
        for (const SlitEdge& edge : shape.graph.edges)
            for (const SlitEdge::Pass& pass : edge.passes)
                has_walls[shape.runs[pieces[pass.piece].run].incision] = 1;
        for (const CutRun& run : shape.runs)
            if (!has_walls[run.incision]) out.outcomes[run.incision].refusal = no_room;
        make_rest(out, shape, all, borders, options.layers, made);
        return out;
    }
    return out;
}

} // namespace

IncisedMesh incise(const CutSkin& skin, std::span<const Incision> all, const InciseOptions& options)
{
    Lender<Mesh> none;
    return incise(skin, all, options, none);
}

IncisedMesh incise(const CutSkin& skin, std::span<const Incision> all, const InciseOptions& options,
                   Lender<Mesh>& made)
{
    Shortfalls shortfalls(all.size());
    for (;;) { // ends as every turn without a result adds a shortfall
        IncisedMesh none;
        none.original = none.rest = skin.mesh();
        none.outcomes.resize(all.size());
        const std::unique_ptr<CutLayout> layout =
            laid_out(skin, all, options.reach, options.rows, none.outcomes, shortfalls);
        if (!layout) continue;
        if (layout->runs.empty()) return none;
        if (std::optional<IncisedMesh> whole =
                cut(*layout, all, options, none.outcomes, shortfalls, made))
            return *std::move(whole);
    }
}

} // namespace trivar
