// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/slit_layout.h"

#include "core/base/finite.h"
#include "core/incise/trace.h"
#include "core/incise/turned_columns.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ranges>

namespace trivar {
namespace {

constexpr double steepest_lean_deg = 75;
constexpr double most_smoothed = 0.25;  // of its length, over which columns of a cut turn
constexpr double least_last_row = 0.02; // of the thickness, where it is a bevel

const char* unfit(const Incision& incision)
{
    if (incision.stroke.size() < 2) return "it has fewer than two points";
    for (const SurfacePoint& each : incision.stroke)
        if (!finite(each.p) || !finite(each.normal)) return "a point of it is not finite";
    if (!(incision.depth > 0 && incision.depth < infinite)) return "it has no depth";
    if (!(incision.width >= 0 && incision.width < infinite)) return "its width is negative";
    if (!(std::abs(incision.lean_deg) <= steepest_lean_deg)) return "it leans too far";
    if (!(incision.bevel >= 0 && incision.bevel < infinite)) return "its bevel is negative";
    return nullptr;
}

// The parts of a stroke that meet the skin.
std::vector<StrokePart> parts_on(const SlitSkin& skin, const Incision& incision, double reach)
{
    const std::vector<std::optional<SkinPlace>> all = skin.locate(incision.stroke, reach);
    const double whole = length_of(incision.stroke);
    std::vector<StrokePart> out;
    double length = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0) length += glm::distance(incision.stroke[i].p, incision.stroke[i - 1].p);
        if (!all[i]) continue;
        if (i == 0 || !all[i - 1]) out.emplace_back();
        out.back().places.push_back(*all[i]);
        out.back().shares.push_back(i + 1 == all.size() ? 1 : whole > 0 ? length / whole : 0);
    }
    return out;
}

// Draws all strokes that can be drawn, and tells whose they are.
std::vector<DrawnStroke> draw(SlitDrawing& drawing, std::span<const Incision> all, double reach,
                              std::vector<IncisedMesh::Outcome>& outcomes)
{
    const SlitSkin& skin = drawing.skin();
    std::vector<DrawnStroke> strokes;
    for (std::uint32_t k = 0; k < all.size(); ++k) {
        if (const char* const why = unfit(all[k])) {
            outcomes[k].refusal = why;
            continue;
        }
        Traced traced = trace(drawing, parts_on(skin, all[k], reach * skin.diagonal()));
        outcomes[k].refusal = std::move(traced.refusal);
        outcomes[k].notice = std::move(traced.notice);
        for (const DrawnChain& chain : traced.chains) {
            drawing.add(chain);
            strokes.push_back({k, chain.from, chain.to});
        }
    }
    drawing.arrange();
    return strokes;
}

std::vector<std::uint32_t> region_of_cuts(const SlitLayout& layout)
{
    std::vector<std::uint32_t> region = layout.drawing.touched();
    for (const SlitRun& run : layout.runs)
        for (const SlitRun::At& at : run.at)
            for (const std::uint32_t t :
                 triangles_round(layout.drawing.skin(), layout.drawing.point(at.point)))
                region.push_back(t);
    return region;
}

// The directions of columns in the region of the cuts.
void find_inward(SlitLayout& layout, std::span<const Incision> all)
{
    layout.inward.emplace(layout.drawing.skin(), region_of_cuts(layout));
    std::vector<Inward::Source> sources;
    for (const SlitRun& run : layout.runs)
        for (std::size_t i = 0; i <= run.last; ++i) {
            const std::uint32_t point = run.at[i].point;
            const double length =
                (run.at[std::min(i + 1, run.last)].s - run.at[i > 0 ? i - 1 : 0].s) / 2;
            sources.push_back({layout.drawing.position(point),
                               layout.inward->outward(layout.drawing.point(point)), length,
                               std::min(all[run.incision].depth, most_smoothed * run.length)});
        }
    layout.inward->follow(std::move(sources));
}

// The far sides of runs that go through, by run. Where columns along the skin's normals are of no
// use, parallel ones may be.
std::vector<FarSide> far_sides(SlitLayout& layout, std::span<const Incision> all)
{
    std::vector<FarSide> out(layout.runs.size());
    std::vector<char> parallel(layout.runs.size(), 0);
    for (bool again = true; again;) {
        again = false;
        layout.columns = columns_of(layout.runs, parallel, layout.drawing, *layout.inward, all);
        for (std::size_t r = 0; r < layout.runs.size(); ++r) {
            if (layout.runs[r].kind != SlitRun::Kind::through) continue;
            FarSide found = far_side(layout.runs[r], layout.drawing, *layout.columns);
            if (!found.refusal.empty() && !parallel[r]) parallel[r] = again = true;
            out[r] = std::move(found);
        }
    }
    return out;
}

bool same_points(const SlitRun& a, const SlitRun& b)
{
    return std::ranges::equal(a.at, b.at, {}, &SlitRun::At::point, &SlitRun::At::point);
}

// Where cuts cross they have one column, and so one last row.
void meet_at_crossings(SlitLayout& layout)
{
    KeyNumbers number;
    std::vector<double> least;
    const auto visit = [&](const auto& use) { // use(depth, number of the crossing)
        for (const ThroughSlit& cut : layout.throughs)
            for (const ThroughSlit::Step& each : cut.crossings) {
                SlitRun::At& at = layout.runs[cut.near].at[each.near];
                const auto [n, fresh] = number.number(at.point);
                if (fresh) least.push_back(at.depth);
                use(at.depth, n);
            }
    };
    visit([&](double depth, std::uint32_t n) { least[n] = std::min(least[n], depth); });
    visit([&](double& depth, std::uint32_t n) { depth = least[n]; });
}

// Draws the far sides of all runs that go through. Why one cannot goes to its shortfall.
void go_through(SlitLayout& layout, std::span<const Incision> all, int rows,
                std::vector<DrawnStroke>& strokes, Shortfalls& shortfalls)
{
    const SlitSkin& skin = layout.drawing.skin();
    for (std::uint32_t r = 0; r < layout.runs.size(); ++r) {
        if (layout.runs[r].kind != SlitRun::Kind::through) continue;
        std::string& shortfall = shortfalls[layout.runs[r].incision];
        shortfall = tangle_of(layout.runs, r, layout.drawing, *layout.inward);
        if (!shortfall.empty()) return;
    }
    const std::vector<SlitRun> before = layout.runs;
    const std::vector<FarSide> far = far_sides(layout, all);
    for (std::uint32_t r = 0; r < before.size(); ++r) {
        if (before[r].kind != SlitRun::Kind::through) continue;
        std::string& shortfall = shortfalls[before[r].incision];
        shortfall = far[r].refusal;
        if (!shortfall.empty()) continue;
        const StrokePart whole{far[r].places};
        const Traced traced = trace(layout.drawing, std::span(&whole, 1));
        if (const std::string& why = traced.refusal.empty() ? traced.notice : traced.refusal;
            !why.empty()) {
            shortfall = "of its other side it is said that " + why;
            continue;
        }
        const std::uint32_t stroke = layout.drawing.add(traced.chains.front());
        strokes.push_back({before[r].incision, before[r].from, before[r].to});
        layout.throughs.push_back({r, stroke, {}});
    }
    layout.drawing.arrange();
    layout.runs = runs_of(layout.drawing, strokes, all);
    for (std::size_t r = 0; r < before.size(); ++r) layout.runs[r].kind = before[r].kind;
    for (const ThroughSlit& cut : layout.throughs)
        layout.runs[cut.far].kind = SlitRun::Kind::far_side;
    const int row_count = std::max(2, rows);
    const double last_row = static_cast<double>(row_count - 1) / row_count;
    for (ThroughSlit& cut : std::views::reverse(layout.throughs)) { // the later one gives way
        SlitRun &near_run = layout.runs[cut.near], &far_run = layout.runs[cut.far];
        std::string& shortfall = shortfalls[near_run.incision];
        if (!same_points(near_run, before[cut.near]))
            shortfall = "its other side crosses a cut";
        else
            shortfall =
                find_crossings(cut, layout.throughs, layout.runs, layout.drawing, *layout.columns);
        if (shortfall.empty()) shortfall = unjoinable(layout.runs, cut);
        if (!shortfall.empty()) return; // the others may go through without it
        cut.zip = zipped(skin, far[cut.near].places, far_run, cut.crossings);
        const std::vector<double>& depths = far[cut.near].depths;
        const Incision& incision = all[near_run.incision];
        for (std::size_t i = 0; i < near_run.at.size(); ++i) {
            const double depth = depths[i > near_run.last ? i - near_run.last : i];
            const double bevel = std::max(far_bevel(incision, depth), least_last_row * depth);
            near_run.at[i].depth = incision.bevel > 0 ? depth - bevel : last_row * depth;
        }
        far_run.near_length = near_run.length;
        for (const ThroughSlit::Step& step : cut.zip)
            far_run.at[step.far].depth = depths[step.near];
    }
    meet_at_crossings(layout);
}

} // namespace

std::unique_ptr<SlitLayout> laid_out(const SlitSkin& skin, std::span<const Incision> all,
                                     double reach, int rows,
                                     std::vector<IncisedMesh::Outcome>& outcomes,
                                     Shortfalls& shortfalls)
{
    auto layout = std::make_unique<SlitLayout>(skin);
    std::vector<DrawnStroke> strokes = draw(layout->drawing, all, reach, outcomes);
    layout->runs = runs_of(layout->drawing, strokes, all);
    find_inward(*layout, all);
    bool any = false;
    for (SlitRun& run : layout->runs)
        if (all[run.incision].floor == Incision::Floor::through &&
            shortfalls[run.incision].empty()) {
            run.kind = SlitRun::Kind::through;
            any = true;
        }
    if (!any) {
        layout->columns = columns_of(layout->runs, std::vector<char>(layout->runs.size(), 0),
                                     layout->drawing, *layout->inward, all);
        return layout;
    }
    const Shortfalls before = shortfalls;
    go_through(*layout, all, rows, strokes, shortfalls);
    if (shortfalls != before) return nullptr;
    find_inward(*layout, all);
    return layout;
}

} // namespace trivar
