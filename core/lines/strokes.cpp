// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/strokes.h"

#include "core/lines/line_marks.h"
#include "core/lines/seen_part.h"
#include "core/lines/stroke_ends.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int reach_of_marks = 2; // points
constexpr int most_steps = 256;   // between two points of a line that is near the eye
constexpr float least_parts = 4;  // of a stroke, so that the smallest loop is still one

StrokePoint between(const StrokePoint& a, const StrokePoint& b, float share)
{
    return {glm::mix(a.at, b.at, share),       glm::mix(a.depth, b.depth, share),
            glm::mix(a.slope, b.slope, share), glm::mix(a.bend, b.bend, share),
            glm::mix(a.p, b.p, share),         glm::mix(a.strength, b.strength, share)};
}

// RunFinder cuts curves where they begin or cease to be hidden.
class RunFinder {
public:
    RunFinder(const Silhouettes& silhouettes, const ImageCurves& curves,
              const std::vector<LineMark>& marks, const std::vector<char>& hidden)
        : silhouettes_(silhouettes),
          curves_(curves),
          marks_(marks),
          hidden_(hidden)
    {
    }
    std::vector<Stroke> operator()()
    {
        for (std::size_t c = 0; c < silhouettes_.count(); ++c) find_runs(c);
        return std::move(out_);
    }

private:
    // A place of a curve as a number of its points, from 0 on, with the share to the next.
    struct Change {
        double at;
        bool hidden; // after it
    };
    std::uint32_t count(std::size_t c) const { return curves_.first[c + 1] - curves_.first[c]; }
    std::size_t index(std::size_t c, std::int64_t i) const
    {
        const auto n = static_cast<std::int64_t>(count(c));
        return curves_.first[c] + static_cast<std::size_t>(((i % n) + n) % n);
    }
    // A point between two of the other kind follows them.
    bool is_hidden(std::size_t c, std::int64_t i) const
    {
        const bool own = hidden_[index(c, i)];
        const auto n = static_cast<std::int64_t>(count(c));
        if (!curves_.closed[c] && (i == 0 || i + 1 == n)) return own;
        const bool before = hidden_[index(c, i - 1)], after = hidden_[index(c, i + 1)];
        return before == after ? before : own;
    }
    // The mark nearest to the middle of the segment from point i on, within reach; that middle
    // where there is none.
    double mark_near(std::size_t c, std::int64_t i) const
    {
        const auto n = static_cast<std::int64_t>(count(c));
        double best = static_cast<double>(i) + 0.5, least = reach_of_marks + 0.5;
        for (std::int64_t s = i - reach_of_marks; s <= i + reach_of_marks; ++s) {
            if (!curves_.closed[c] && (s < 0 || s + 1 >= n)) continue;
            const auto point = static_cast<std::uint32_t>(index(c, s));
            for (auto mark = std::ranges::lower_bound(marks_, point, {}, &LineMark::point);
                 mark != marks_.end() && mark->point == point; ++mark) {
                const double at = static_cast<double>(s) + mark->share;
                if (std::abs(at - static_cast<double>(i) - 0.5) >= least) continue;
                least = std::abs(at - static_cast<double>(i) - 0.5);
                best = at;
            }
        }
        return best;
    }
    StrokePoint point_at(std::size_t c, double at) const
    {
        const auto i = static_cast<std::int64_t>(std::floor(at));
        return between(curves_.points[index(c, i)], curves_.points[index(c, i + 1)],
                       static_cast<float>(at - static_cast<double>(i)));
    }
    void find_runs(std::size_t c)
    {
        const auto n = static_cast<std::int64_t>(count(c));
        if (n < 2) return;
        std::vector<Change> changes;
        for (std::int64_t i = 0; i + (curves_.closed[c] ? 0 : 1) < n; ++i)
            if (const bool after = is_hidden(c, i + 1); after != is_hidden(c, i))
                changes.push_back({mark_near(c, i), after});
        for (std::size_t k = 1; k < changes.size(); ++k) // marks may have overtaken each other
            changes[k].at = std::max(changes[k].at, changes[k - 1].at);
        const auto length = static_cast<double>(n);
        if (changes.empty()) {
            add(c, 0, curves_.closed[c] ? length : length - 1, is_hidden(c, 0));
        } else if (curves_.closed[c]) {
            for (std::size_t k = 0; k < changes.size(); ++k) {
                const double end =
                    k + 1 < changes.size() ? changes[k + 1].at : changes[0].at + length;
                add(c, changes[k].at, end, changes[k].hidden);
            }
        } else {
            add(c, 0, changes[0].at, !changes[0].hidden);
            for (std::size_t k = 0; k < changes.size(); ++k)
                add(c, changes[k].at, k + 1 < changes.size() ? changes[k + 1].at : length - 1,
                    changes[k].hidden);
        }
    }
    void add(std::size_t c, double from, double to, bool hidden)
    {
        if (!(to > from)) return;
        Stroke run;
        run.hidden = hidden;
        run.id = ~std::uint64_t{0};
        const bool whole = curves_.closed[c] && to - from >= static_cast<double>(count(c));
        run.points.push_back(point_at(c, from));
        for (auto i = static_cast<std::int64_t>(std::floor(from)) + 1; static_cast<double>(i) < to;
             ++i) {
            run.points.push_back(curves_.points[index(c, i)]);
            run.id = std::min(run.id, silhouettes_.points[index(c, i)].edge);
        }
        run.id =
            std::min(run.id, silhouettes_.points[index(c, static_cast<std::int64_t>(from))].edge);
        run.points.push_back(whole ? run.points.front() : point_at(c, to));
        if (whole) run.tapers_first = run.tapers_last = false;
        out_.push_back(std::move(run));
    }

    const Silhouettes& silhouettes_;
    const ImageCurves& curves_;
    const std::vector<LineMark>& marks_;
    const std::vector<char>& hidden_;
    std::vector<Stroke> out_;
};

// Leaves out points that are nearer to the last one than the spacing, and puts points on the
// Catmull-Rom curve through those that stay.
void make_smooth(Stroke& stroke, float spacing)
{
    spacing = std::min(spacing, static_cast<float>(stroke.length()) / least_parts);
    const bool loop = stroke.is_loop();
    std::vector<StrokePoint> kept;
    for (const StrokePoint& p : stroke.points)
        if (kept.empty() || glm::distance(p.at, kept.back().at) >= spacing) kept.push_back(p);
    if (kept.back().at != stroke.points.back().at) {
        if (kept.size() > 1 && glm::distance(kept.back().at, stroke.points.back().at) < spacing / 2)
            kept.pop_back();
        kept.push_back(stroke.points.back());
    }
    const auto n = static_cast<std::ptrdiff_t>(kept.size());
    if (n < 3) {
        stroke.points = std::move(kept);
        return;
    }
    const auto at = [&](std::ptrdiff_t i) -> const StrokePoint& {
        if (i < 0) return loop ? kept[static_cast<std::size_t>(n - 2)] : kept.front();
        if (i >= n) return loop ? kept[1] : kept.back();
        return kept[static_cast<std::size_t>(i)];
    };
    stroke.points.clear();
    for (std::ptrdiff_t i = 0; i + 1 < n; ++i) {
        const StrokePoint &b = at(i), &c = at(i + 1);
        const float length = glm::distance(b.at, c.at),
                    before = std::max(1e-6f, glm::distance(at(i - 1).at, b.at)),
                    after = std::max(1e-6f, glm::distance(c.at, at(i + 2).at));
        const StrokePoint &a = at(i - 1), &d = at(i + 2);
        const int steps = std::clamp(static_cast<int>(length / spacing), 1, most_steps);
        for (int k = 0; k < steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps), s = 1 - t;
            const auto on_curve = [&](auto StrokePoint::*place) {
                const auto leaving = (c.*place - a.*place) * (length / (length + before)),
                           arriving = (d.*place - b.*place) * (length / (length + after));
                return (1 + 2 * t) * s * s * b.*place + t * s * s * leaving +
                       (1 + 2 * s) * t * t * c.*place - s * t * t * arriving;
            };
            StrokePoint p = between(b, c, t);
            p.at = on_curve(&StrokePoint::at);
            p.p = on_curve(&StrokePoint::p);
            stroke.points.push_back(p);
        }
    }
    stroke.points.push_back(kept.back());
}

} // namespace

std::vector<Stroke> strokes(const Silhouettes& silhouettes, const std::vector<char>& hidden,
                            const glm::dmat4& to_image, const StrokeOptions& options)
{
    if (const std::optional<SeenPart> part = seen_part(silhouettes, hidden, to_image))
        return strokes(part->curves, part->hidden, to_image, options);
    const ImageCurves curves = in_image(silhouettes, to_image);
    std::vector<Stroke> out =
        joined(RunFinder(silhouettes, curves, line_marks(curves), hidden)(), options.join);
    std::erase_if(
        out, [&](const Stroke& s) { return s.length() < options.shortest || s.length() == 0; });
    for (Stroke& stroke : out) make_smooth(stroke, options.spacing);
    return out;
}

} // namespace trivar
