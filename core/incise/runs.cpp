// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/runs.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr double share_of_thickness = 0.42; // so that walls from both sides of a body do not meet
constexpr double steepest = 1.5;            // of a floor, along the cut
constexpr double least_cosine = -0.3;       // of the turn of a piece
constexpr std::size_t most_pieces = 64;     // of a run
constexpr double least_overlap = 1e-9;      // of the length
constexpr double bevel_of_depth = 0.5;      // of the depth, at most
constexpr double room_over = 0.5;           // of the depth, over which its limits are smooth
constexpr double well_inside = 0.5;         // share of the greatest depth that is asked for there
constexpr double far_bevel_of_thickness = 0.25;
constexpr double gone_round = 0.1;  // of the length: so far a loop goes on
constexpr double least_left = 0.15; // of the way between two columns, at the floor

void go_on_round(SlitRun& run)
{
    for (std::size_t i = 1; i < run.last && run.at[i - 1].s < gone_round * run.length; ++i)
        run.at.push_back({run.at[i].point, run.length + run.at[i].s});
}

// Floors no steeper along the run than is good for the strips of walls.
void flatten(SlitRun& run)
{
    const auto limit = [&](std::size_t from, std::size_t to) {
        const double most = run.at[from].depth + steepest * std::abs(run.at[to].s - run.at[from].s);
        run.at[to].depth = std::min(run.at[to].depth, most);
    };
    const std::size_t last = run.last;
    for (int round = 0; round < (run.closed() ? 2 : 1); ++round) {
        for (std::size_t i = 1; i <= last; ++i) limit(i - 1, i);
        if (run.closed()) run.at.front().depth = run.at[last].depth;
        for (std::size_t i = last; i-- > 0;) limit(i + 1, i);
        if (run.closed()) run.at[last].depth = run.at.front().depth;
    }
    for (std::size_t i = last + 1; i < run.at.size(); ++i) run.at[i].depth = run.at[i - last].depth;
}

// Finds the thickness of the body below the points of each run, along its columns.
void find_thickness(std::vector<SlitRun>& runs, const SlitDrawing& drawing,
                    const SlitColumns& columns)
{
    std::vector<Ray> rays;
    std::vector<double> slants; // of the way down to the depth
    for (const SlitRun& run : runs)
        for (const SlitRun::At& at : run.at) {
            const glm::dvec3 n = columns.outward(at.point);
            const double length = glm::length(n);
            slants.push_back(std::max(1.0, length));
            rays.push_back(
                {drawing.position(at.point), length > 0 ? -n / length : glm::dvec3(0, 0, -1)});
        }
    const std::vector<double> all = drawing.skin().thickness(rays);
    auto slant = slants.begin();
    auto next = all.begin();
    for (SlitRun& run : runs)
        for (SlitRun::At& at : run.at) at.thickness = *next++ / *slant++;
}

} // namespace

std::vector<SlitRun> runs_of(const SlitDrawing& drawing, std::span<const DrawnStroke> strokes,
                             std::span<const Incision> incisions)
{
    std::vector<std::vector<SlitDrawing::Segment>> segments(drawing.stroke_count());
    for (const SlitDrawing::Segment& g : drawing.segments())
        if (g.a != g.b) segments[g.stroke].push_back(g);
    std::vector<SlitRun> out;
    for (std::uint32_t k = 0; k < drawing.stroke_count(); ++k) {
        std::ranges::stable_sort(segments[k], {}, [](const auto& g) { return g.s_a + g.s_b; });
        const DrawnStroke& of = strokes[k];
        const Incision& incision = incisions[of.incision];
        const double length = drawing.length(k);
        SlitRun run{of.incision, length, of.from, of.to, width_of(incision, length), {}};
        for (const SlitDrawing::Segment& g : segments[k]) {
            if (run.at.empty()) run.at.push_back({g.a, g.s_a});
            run.at.push_back({g.b, g.s_b});
        }
        run.last = run.at.size() - 1;
        if (run.closed()) go_on_round(run);
        out.push_back(std::move(run));
    }
    return out;
}

void set_depths(std::vector<SlitRun>& runs, const SlitDrawing& drawing, const Inward& inward,
                const SlitColumns& columns, std::span<const Incision> incisions,
                std::span<const Narrowing> shares)
{
    double deepest = 0;
    for (const SlitRun& run : runs)
        if (run.has_floor()) deepest = std::max(deepest, incisions[run.incision].depth);
    find_thickness(runs, drawing, columns);
    KeyNumbers known;
    std::vector<double> below;
    for (SlitRun& run : runs) {
        if (!run.has_floor()) continue;
        const Incision& incision = incisions[run.incision];
        std::vector<double> room; // for the depth, by point
        for (std::size_t i = 0; i <= run.last; ++i) {
            room.push_back(std::min(incision.depth, share_of_thickness * run.at[i].thickness));
            for (const std::uint32_t t :
                 triangles_round(drawing.skin(), drawing.point(run.at[i].point))) {
                const auto [number, fresh] = known.number(t);
                if (fresh) below.push_back(inward.depth_below(t, deepest));
                room.back() = std::min(room.back(), below[number]);
            }
        }
        smooth_room(run, room_over * incision.depth, room);
        for (std::size_t i = 0; i <= run.last; ++i) {
            SlitRun::At& at = run.at[i];
            at.depth = std::min(incision.depth * run.value(incision.depth_profile, at.s), room[i]) *
                       shares[run.incision].at(run.share(at.s));
        }
        for (std::size_t i = 1; i <= run.last; ++i) {
            SlitRun::At &a = run.at[i - 1], &b = run.at[i];
            const double most =
                columns.sound_depth(a.point, b.point, std::max(a.depth, b.depth), least_left);
            a.depth = std::min(a.depth, most);
            b.depth = std::min(b.depth, most);
        }
        for (std::size_t i = 0; i <= run.last; ++i)
            if (const double asked = run.value(incision.depth_profile, run.at[i].s);
                asked > well_inside)
                run.least_depth =
                    std::min(run.least_depth, run.at[i].depth / (asked * incision.depth));
        if (!run.closed()) run.at.front().depth = run.at.back().depth = 0;
        flatten(run);
    }
}

void smooth_room(const SlitRun& run, double way, std::vector<double>& room)
{
    const bool round = run.closed();
    const std::size_t count = run.last + (round ? 0 : 1);
    const auto visit_near = [&](std::size_t i, const auto& visit) {
        visit(i);
        for (const bool on : {true, false})
            for (std::size_t d = 1; d < count && (round || (on ? i + d < count : d <= i)); ++d) {
                const std::size_t k = (on ? i + d : i + count - d) % count;
                const double away = std::abs(run.at[k].s - run.at[i].s);
                if ((round ? std::min(away, run.length - away) : away) > way) break;
                visit(k);
            }
    };
    std::vector<double> least = room;
    for (std::size_t i = 0; i < count; ++i)
        visit_near(i, [&](std::size_t k) { least[i] = std::min(least[i], room[k]); });
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0, lengths = 0;
        visit_near(i, [&](std::size_t k) {
            const double length = run.at[std::min(k + 1, run.last)].s - run.at[k > 0 ? k - 1 : 0].s;
            sum += length * (least[k] - room[i]);
            lengths += length;
        });
        room[i] = lengths > 0 ? room[i] + std::min(0.0, sum / lengths) : least[i];
    }
    for (std::size_t i = count; i < room.size(); ++i) room[i] = room[i - run.last];
}

double depth_at(const SlitRun& run, double s)
{
    if (s <= run.at.front().s) return run.at.front().depth;
    if (s >= run.at.back().s) return run.at.back().depth;
    const auto next = std::ranges::upper_bound(run.at, s, {}, &SlitRun::At::s);
    const SlitRun::At &a = *(next - 1), &b = *next;
    const double share = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0;
    return (1 - share) * a.depth + share * b.depth;
}

double bevel_at(const SlitRun& run, const Incision& incision, double s)
{
    return std::min(incision.bevel, bevel_of_depth * depth_at(run, s));
}

double far_bevel(const Incision& incision, double thickness)
{
    return std::min(incision.bevel, far_bevel_of_thickness * thickness);
}

double SlitPiece::weight(double s) const
{
    if (s < begin || s > end) return 0;
    double w = 1;
    if (s < full_from) w = full_from > begin ? (s - begin) / (full_from - begin) : 1;
    if (s > full_to) w = std::min(w, end > full_to ? (end - s) / (end - full_to) : 1);
    return std::clamp(w, 0.0, 1.0);
}

std::vector<SlitPiece> pieces_of(const std::vector<SlitRun>& runs, const SlitDrawing& drawing)
{
    std::vector<SlitPiece> out;
    for (std::uint32_t k = 0; k < runs.size(); ++k) {
        const std::vector<SlitRun::At>& at = runs[k].at;
        std::size_t made = 0;
        const double whole = runs[k].length; // a loop goes on beyond it: there pieces overlap
        double begin = 0, full_from = at.back().s - whole;
        std::size_t first = 0; // of the piece
        std::vector<std::pair<std::uint32_t, double>> seen{{at[0].point, at[0].s}};
        const auto along = [&](std::size_t i) { // from point i to the next
            return glm::normalize(drawing.position(at[i + 1].point) -
                                  drawing.position(at[i].point));
        };
        for (std::size_t i = 0; i + 1 < at.size();) {
            if (i > first && at[i + 1].point == at[i - 1].point && made < most_pieces) {
                out.push_back({k, begin, at[i].s, full_from, at[i].s}); // it turns round here
                ++made;
                begin = full_from = at[i].s;
                first = i;
                seen = {{at[i].point, at[i].s}};
            }
            const double s = at[i + 1].s;
            double from = -1; // where the next piece has to begin at the latest
            const auto before =
                std::ranges::find(seen, at[i + 1].point, &std::pair<std::uint32_t, double>::first);
            if (before != seen.end())
                from = std::max(before->second, full_from);
            else if (glm::dot(along(i), along(first)) < least_cosine)
                from = std::max(full_from, 0.5 * (begin + s));
            if (from < 0 || !(s - from > least_overlap * whole) || made >= most_pieces ||
                s > whole) {
                seen.emplace_back(at[i + 1].point, s);
                ++i;
                continue;
            }
            const double middle = (from + s) / 2, half = (s - from) / 4;
            out.push_back({k, begin, middle + half, full_from, middle - half});
            ++made;
            begin = middle - half;
            full_from = middle + half;
            std::size_t back = 0;
            while (back < i && at[back + 1].s <= begin) ++back;
            i = first = back;
            seen = {{at[i].point, at[i].s}};
        }
        out.push_back({k, begin, at.back().s, full_from, whole});
    }
    return out;
}

} // namespace trivar
