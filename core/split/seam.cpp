// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/seam.h"

#include "core/base/smooth_step.h"
#include "core/split/rim_loops.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// The room that the opening must have beyond a loop, and how much more than that it is drawn in, as
// shares of the height of the loops sewn at that place.
constexpr double least_room = 0.25, room_share = 0.02;
// Loops that are nearer to each other than that are sewn at one place: of both heights, and of the
// height of all
constexpr double least_gap = 0.25, least_gap_of_all = 0.1;
// The share of the way from an end of the opening to the obstacle over which it is drawn in. The
// halves have not parted there, so no slit comes between them above the seam.
constexpr double drawing_in = 0.6;

// The cubic between two knots.
struct Piece {
    Seam::Knot from, to;

    double length() const { return to.w - from.w; }
    double rise() const { return (to.target - from.target) / length(); }
    Seam::Slope at(double w) const
    {
        const double x = (w - from.w) / length(), y = 1 - x;
        const double up = smooth_step(x);
        return {from.target + (to.target - from.target) * up +
                    length() * (from.slope * x * y * y - to.slope * x * x * y),
                6 * rise() * x * y + from.slope * y * (y - 2 * x) + to.slope * x * (x - 2 * y)};
    }
    double most_slope() const { return 1.5 * rise() + std::max(from.slope, to.slope); }
    double most_bent() const // it is linear, so greatest at an end
    {
        return std::max(std::abs(6 * rise() - 4 * from.slope - 2 * to.slope),
                        std::abs(-6 * rise() + 2 * from.slope + 4 * to.slope)) /
               length();
    }
};

// A Span is the interval of the opening that a loop covers, or several that overlap along w.
struct Span {
    double lo, hi, length, sum; // sum: of w by length

    double mean() const { return sum / length; }
};

std::vector<Span> spans_of(const std::vector<RimLoop>& loops, const std::vector<glm::dvec2>& places,
                           const glm::dvec2& way)
{
    std::vector<Span> out;
    for (const RimLoop& loop : loops) {
        Span span{1e300, -1e300, 0, 0};
        for (std::size_t i = 0; i < loop.size(); ++i) {
            glm::dvec2 a = places[loop[i]], b = places[loop[(i + 1) % loop.size()]];
            if (a.x > b.x) std::swap(a, b);
            if (b.x <= way.x || a.x >= way.y) continue;
            const auto at = [&](double v) {
                return b.x > a.x ? glm::mix(a, b, (v - a.x) / (b.x - a.x)) : a;
            };
            const glm::dvec2 from = a.x < way.x ? at(way.x) : a, to = b.x > way.y ? at(way.y) : b;
            const double length = glm::distance(from, to);
            span.lo = std::min({span.lo, from.y, to.y});
            span.hi = std::max({span.hi, from.y, to.y});
            span.length += length;
            span.sum += length * (from.y + to.y) / 2;
        }
        if (span.length > 0 && span.lo < span.hi) out.push_back(span);
    }
    std::ranges::sort(out, {}, &Span::lo);
    double top = -1e300;
    for (const Span& span : out) top = std::max(top, span.hi);
    std::size_t last = 0;
    for (std::size_t i = 1; i < out.size(); ++i) {
        const double heights = out[last].hi - out[last].lo + out[i].hi - out[i].lo;
        if (out[i].lo - out[last].hi <=
            std::max(least_gap * heights, least_gap_of_all * (top - out.front().lo))) {
            out[last].hi = std::max(out[last].hi, out[i].hi);
            out[last].length += out[i].length;
            out[last].sum += out[i].sum;
        } else
            out[++last] = out[i];
    }
    if (!out.empty()) out.resize(last + 1);
    return out;
}

// The knots of T for an opening from lo to hi; none where it would fall.
std::vector<Seam::Knot> knots_of(const std::vector<Span>& spans, double lo, double hi)
{
    std::vector<Seam::Knot> out{{lo, lo, 1}};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Span& span = spans[i];
        if (span.hi <= lo || span.lo >= hi) continue;
        const double height = span.hi - span.lo;
        const auto pad = [&](double gap) { return std::min(room_share * height, gap / 8); };
        const double low = span.lo - pad(i > 0 ? span.lo - spans[i - 1].hi : height);
        const double high =
            span.hi + pad(i + 1 < spans.size() ? spans[i + 1].lo - span.hi : height);
        const bool ends_below = span.lo - lo >= least_room * height;
        const bool ends_above = hi - span.hi >= least_room * height;
        if (ends_below && ends_above) {
            out.push_back({low, span.mean(), 0});
            out.push_back({high, span.mean(), 0});
        } else if (ends_above) { // down to where the opening ends
            out.back().slope = 0;
            out.push_back({high, lo, 0});
        } else if (ends_below) {
            out.push_back({low, hi, 0});
            out.push_back({hi, hi, 0});
        } else
            return {};
    }
    if (out.size() == 1) return {};
    if (out.back().w < hi) out.push_back({hi, hi, 1});
    for (std::size_t i = 1; i < out.size(); ++i)
        if (!(out[i - 1].w < out[i].w && out[i - 1].target <= out[i].target)) return {};
    return out;
}

} // namespace

Seam::Slope Seam::target(double w) const
{
    if (knots.empty() || w <= knots.front().w || w >= knots.back().w) return {w, 1};
    std::size_t i = 1;
    while (knots[i].w < w) ++i;
    return Piece{knots[i - 1], knots[i]}.at(w);
}

Seam::Slope Seam::share(double v) const
{
    const bool first = v - way.x < way.y - v;
    const double x = std::clamp((first ? v - way.x : way.y - v) / ends, 0.0, 1.0);
    return {smooth_step(x), (first ? 6 : -6) * x * (1 - x) / ends};
}

SeamBound bound(const Seam& seam, double w_from, double w_to)
{
    SeamBound out{w_from, w_to};
    if (!seam.draws() || w_to <= seam.knots.front().w || w_from >= seam.knots.back().w) return out;
    out.lo = std::min(w_from, seam.target(w_from).value);
    out.hi = std::max(w_to, seam.target(w_to).value);
    out.most = out.hi - out.lo; // of any point and where it is led to
    out.slope = w_from < seam.knots.front().w || w_to > seam.knots.back().w ? 1 : 0;
    for (std::size_t i = 1; i < seam.knots.size(); ++i) {
        const Piece piece{seam.knots[i - 1], seam.knots[i]};
        if (piece.to.w < w_from || piece.from.w > w_to) continue;
        const double slope = piece.most_slope();
        out.slope = std::max(out.slope, slope);
        out.slope_less_1 = std::max({out.slope_less_1, 1.0, slope - 1});
        out.bend = std::max(out.bend, piece.most_bent());
    }
    for (const Seam::Knot& knot : {seam.knots.front(), seam.knots.back()})
        if (knot.w >= w_from && knot.w <= w_to)
            out.kink = std::max(out.kink, std::abs(1 - knot.slope));
    return out;
}

ShareBound share_bound(const Seam& seam, double v_from, double v_to)
{
    const double middle = std::clamp((seam.way.x + seam.way.y) / 2, v_from, v_to);
    const double value = seam.share(middle).value;
    const double least = std::min(seam.share(v_from).value, seam.share(v_to).value);
    const bool level = v_from >= seam.way.x + seam.ends && v_to <= seam.way.y - seam.ends;
    if (level) return {least, value, 0, 0};
    return {least, value, 1.5 / seam.ends, 6 / (seam.ends * seam.ends)};
}

Seam seam_of(const CutMesh& cut, const SplitField& field, std::size_t opening)
{
    const Opening& o = field.openings[opening];
    const glm::dvec2 lo = o.walls[0].lo(), hi = o.walls[0].hi();
    Seam out{{}, {lo.x, hi.x}, drawing_in * o.ends};
    if (cut.rim.empty()) return out;
    std::vector<glm::dvec2> places;
    for (const glm::vec3& p : cut.places) {
        const glm::dvec3 uvw = field.frame.uvw(glm::dvec3(p));
        places.emplace_back(uvw.y, uvw.z);
    }
    RimLoops loops = loops_of(cut.rim, places.size());
    for (RimLoop& loop : joined_ways(loops.open, places)) loops.closed.push_back(std::move(loop));
    out.knots = knots_of(spans_of(loops.closed, places, out.way), lo.y, hi.y);
    return out;
}

DrawnIn drawn_in(const SplitField& field, std::span<const Seam> seams, const glm::dvec3& uvw,
                 std::span<const char> sides, std::span<const char> on)
{
    DrawnIn out{uvw};
    const glm::dvec2 vw(uvw.y, uvw.z);
    for (std::size_t i = 0; i < seams.size(); ++i) {
        const Opening& o = field.openings[i];
        if (!seams[i].draws() || o.beyond_walls(vw)) continue;
        const BicubicCells::Jet phi = o.surface_cells.jet(vw);
        const double sign = sides[i] ? 1 : -1, reach = drawn_reach * o.reach[sides[i] ? 1 : 0];
        const double h = uvw.x - phi.value;
        const double x = on[i] ? 0 : std::max(0.0, sign * h) / reach;
        if (x >= 1) continue;
        const Seam::Slope share = seams[i].share(vw.x), target = seams[i].target(vw.y);
        const double fade = (1 - x) * (1 - x), away = target.value - vw.y;
        const glm::dvec3 h_gradient(1, -phi.u, -phi.v);
        glm::dvec3 pull_gradient = share.value * (-2 * (1 - x) * sign / reach) * h_gradient;
        pull_gradient.y += fade * share.slope;
        const double pull = fade * share.value;
        out.uvw.z = vw.y + pull * away;
        out.w = away * pull_gradient + glm::dvec3(0, 0, 1 + pull * (target.slope - 1));
        const BicubicCells::Jet there = o.surface_cells.jet({vw.x, out.uvw.z});
        out.uvw.x = uvw.x + (there.value - phi.value);
        out.u = h_gradient + glm::dvec3(0, there.u, 0) + there.v * out.w;
        return out;
    }
    return out;
}

} // namespace trivar
