// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incise.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/incise/guard.h"
#include "core/incise/incised_mesh.h"
#include "core/incise/trace.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double shallower_at_rest = 0.6, shallower_when_open = 0.5;
constexpr int most_attempts = 12, most_open_attempts = 4;
constexpr const char* no_room = "the body has no room for its depth there";
constexpr double hardly_open = 0.02; // share of the width

const char* unfit(const Incision& incision)
{
    if (incision.stroke.size() < 2) return "it has fewer than two points";
    for (const SurfacePoint& each : incision.stroke)
        if (!finite(each.p) || !finite(each.normal)) return "a point of it is not finite";
    if (!(incision.depth > 0 && incision.depth < infinite)) return "it has no depth";
    if (!(incision.width >= 0 && incision.width < infinite)) return "its width is negative";
    return nullptr;
}

// Where a stroke meets the skin; empty, with a sentence, where it leaves it.
std::vector<SkinPlace> places_of(const CutSkin& skin, const Incision& incision, double reach,
                                 std::string& refusal)
{
    std::vector<SkinPlace> out;
    for (const std::optional<SkinPlace>& place : skin.locate(incision.stroke, reach)) {
        if (!place) {
            refusal = "it leaves the surface";
            return {};
        }
        out.push_back(*place);
    }
    return out;
}

// The drawing of all strokes that can be drawn. Which incision each is of goes to `incisions`.
CutDrawing drawn(const CutSkin& skin, std::span<const Incision> all, const InciseOptions& options,
                 std::vector<IncisedMesh::Outcome>& outcomes, std::vector<std::uint32_t>& incisions)
{
    CutDrawing drawing(skin);
    for (std::uint32_t k = 0; k < all.size(); ++k) {
        std::string& refusal = outcomes[k].refusal;
        if (const char* const why = unfit(all[k])) {
            refusal = why;
            continue;
        }
        const std::vector<SkinPlace> places =
            places_of(skin, all[k], options.reach * skin.diagonal(), refusal);
        if (!refusal.empty()) continue;
        Traced traced = trace(drawing, places);
        refusal = std::move(traced.refusal);
        if (!refusal.empty()) continue;
        drawing.add(traced.chain);
        incisions.push_back(k);
    }
    drawing.arrange();
    return drawing;
}

} // namespace

IncisedMesh incise(const CutSkin& skin, std::span<const Incision> all, const InciseOptions& options)
{
    IncisedMesh out;
    out.original = out.rest = skin.mesh();
    out.outcomes.resize(all.size());
    std::vector<std::uint32_t> incision_of_stroke;
    const CutDrawing drawing = drawn(skin, all, options, out.outcomes, incision_of_stroke);
    if (drawing.stroke_count() == 0) return out;

    const std::vector<CutRun> runs = runs_of(drawing, incision_of_stroke);
    std::vector<SkinTriangle> pieces_of_skin;
    std::vector<std::uint32_t> region = drawing.touched();
    for (const std::uint32_t t : region)
        for (const SkinTriangle& piece : filled(drawing, t)) pieces_of_skin.push_back(piece);
    for (const CutRun& run : runs)
        for (const CutRun::At& at : run.at)
            for (const std::uint32_t t : triangles_round(skin, drawing.point(at.point)))
                region.push_back(t);
    const Inward inward(skin, region);
    const std::vector<CutPiece> pieces = pieces_of(runs, drawing);

    double deepest = 0;
    for (const CutRun& run : runs) deepest = std::max(deepest, all[run.incision].depth);
    const double step = deepest / depth_steps;
    std::vector<int> borders;
    for (std::size_t i = 0; i + 1 < options.layers.size(); ++i)
        borders.push_back(static_cast<int>(
            std::lround(std::min(1.0, options.layers[i].depth / deepest) * depth_steps)));
    std::ranges::sort(borders);

    double scale = 1;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        CutShape shape{drawing, inward, step, runs, pieces, {}, {}, {}, {}};
        set_depths(shape.runs, drawing, inward, all, scale);
        shape.graph = slits_of(shape.runs, pieces, all, drawing, inward, step,
                               depth_steps / std::max(1, options.rows) / 2);
        if (shape.graph.edges.empty()) {
            for (const CutRun& run : runs) out.outcomes[run.incision].refusal = no_room;
            return out;
        }
        shape.patch = patch_of(drawing, pieces_of_skin, shape.graph);
        shape.walls = walls_of(drawing, shape.patch, shape.graph, options.rows, borders);
        shape.terms = field_of(drawing, shape.patch, shape.graph, shape.walls, shape.runs, pieces,
                               all, inward, step);
        std::vector<double> shares(all.size(), 1.0);
        if (options.guarded) {
            shares = admissible_shares(shape, all.size());
            const bool last = attempt + 1 == most_attempts;
            if (shares.empty() && !last) {
                scale *= shallower_at_rest;
                continue;
            }
            shares.resize(all.size(), 0.0);
            const double widest = *std::ranges::max_element(shares);
            if (widest < hardly_open && attempt < most_open_attempts) {
                scale *= shallower_when_open;
                continue;
            }
        }
        for (const CutRun& run : shape.runs) {
            IncisedMesh::Outcome& outcome = out.outcomes[run.incision];
            outcome.length = run.length;
            for (const CutRun::At& at : run.at) outcome.depth = std::max(outcome.depth, at.depth);
            outcome.widest = shares[run.incision];
        }
        std::vector<char> has_walls(all.size(), 0);
        for (const SlitEdge& edge : shape.graph.edges)
            for (const SlitEdge::Pass& pass : edge.passes)
                has_walls[shape.runs[pieces[pass.piece].run].incision] = 1;
        for (const CutRun& run : shape.runs)
            if (!has_walls[run.incision]) out.outcomes[run.incision].refusal = no_room;
        make_rest(out, shape, all, borders, options.layers);
        return out;
    }
    return out;
}

} // namespace trivar
