// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/loop_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace trivar {
namespace {

constexpr int most_cuts_of_all = 40;
constexpr std::size_t most_steps = 20000;

using Wide = glm::i64vec2;

std::int64_t turn_of(const Wide& a, const Wide& b, const Wide& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The ways of the edges, as points, and the cutting of them where they meet.
class CrossingWays {
public:
    explicit CrossingWays(const std::vector<std::vector<glm::ivec2>>& loops)
    {
        for (const std::vector<glm::ivec2>& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i)
                ways_.push_back({number(loop[i]), number(loop[(i + 1) % loop.size()])});
        for (std::vector<std::uint32_t>& way : ways_) // of one point
            way.erase(std::unique(way.begin(), way.end()), way.end());
    }
    // Returns whether nothing crosses any more.
    bool cut_all()
    {
        for (int round = 0; round < most_cuts_of_all; ++round) {
            std::vector<Segment> all;
            for (std::uint32_t w = 0; w < ways_.size(); ++w)
                for (std::uint32_t k = 0; k + 1 < ways_[w].size(); ++k)
                    all.push_back(segment(w, k));
            if (all.size() > most_steps) return false;
            std::ranges::sort(all, {}, [](const Segment& s) { return s.lo.x; });
            cuts_.clear();
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = i + 1; j < all.size() && all[j].lo.x <= all[i].hi.x; ++j)
                    if (all[j].lo.y <= all[i].hi.y && all[j].hi.y >= all[i].lo.y)
                        meet(all[i], all[j]);
            if (cuts_.empty()) return true;
            apply();
        }
        return false;
    }
    const std::vector<std::vector<std::uint32_t>>& ways() const { return ways_; }
    const std::vector<glm::ivec2>& points() const { return points_; }

private:
    struct Segment {
        std::uint32_t way, at; // from point `at` of the way to the next one
        Wide a, b, lo, hi;
    };
    struct Cut {
        std::uint32_t way, at;
        std::int64_t along; // the way, to sort by
        std::uint32_t point;
        auto operator<=>(const Cut&) const = default;
    };

    std::uint32_t number(const glm::ivec2& p)
    {
        const auto [found, is_new] =
            numbers_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(points_.size()));
        if (is_new) points_.push_back(p);
        return found->second;
    }
    Segment segment(std::uint32_t way, std::uint32_t at) const
    {
        const Wide a(points_[ways_[way][at]]), b(points_[ways_[way][at + 1]]);
        return {way, at, a, b, glm::min(a, b), glm::max(a, b)};
    }
    void add(const Segment& s, const Wide& p)
    {
        if (p == s.a || p == s.b) return;
        const Wide d = s.b - s.a, e = p - s.a;
        cuts_.push_back({s.way, s.at, d.x * e.x + d.y * e.y, number(glm::ivec2(p))});
    }
    static bool is_on(const Segment& s, const Wide& p)
    {
        return turn_of(s.a, s.b, p) == 0 && p.x >= s.lo.x && p.x <= s.hi.x && p.y >= s.lo.y &&
               p.y <= s.hi.y;
    }
    void meet(const Segment& s, const Segment& t)
    {
        bool touch = false;
        for (const Wide& p : {t.a, t.b})
            if (is_on(s, p)) touch = true, add(s, p);
        for (const Wide& p : {s.a, s.b})
            if (is_on(t, p)) touch = true, add(t, p);
        if (touch) return;
        const auto over = [](std::int64_t x, std::int64_t y) { return (x > 0) != (y > 0); };
        const std::int64_t a = turn_of(t.a, t.b, s.a), b = turn_of(t.a, t.b, s.b);
        if (!over(a, b) || !over(turn_of(s.a, s.b, t.a), turn_of(s.a, s.b, t.b))) return;
        const double share =
            static_cast<double>(a) / (static_cast<double>(a) - static_cast<double>(b));
        const Wide p = s.a + Wide(glm::round(glm::dvec2(s.b - s.a) * share));
        add(s, p);
        add(t, p);
    }
    void apply()
    {
        std::ranges::sort(cuts_);
        std::vector<std::vector<std::uint32_t>> out(ways_.size());
        auto next = cuts_.begin();
        for (std::uint32_t w = 0; w < ways_.size(); ++w)
            for (std::uint32_t k = 0; k < ways_[w].size(); ++k) {
                out[w].push_back(ways_[w][k]);
                for (; next != cuts_.end() && next->way == w && next->at == k; ++next)
                    if (out[w].back() != next->point) out[w].push_back(next->point);
            }
        ways_ = std::move(out);
    }

    std::map<std::pair<int, int>, std::uint32_t> numbers_;
    std::vector<glm::ivec2> points_;
    std::vector<std::vector<std::uint32_t>> ways_;
    std::vector<Cut> cuts_;
};

// The steps between two points, of which the second is above the first, or
// right of it.
struct Bundle {
    std::uint32_t from, to;
    std::vector<LoopLayers::Step*> there, back;

    int net() const { return static_cast<int>(there.size()) - static_cast<int>(back.size()); }
};

// Returns how often the loops run round the place left of the middle of a bundle.
int winding_left_of(const Bundle& bundle, const std::vector<Bundle>& all,
                    const std::vector<glm::ivec2>& points)
{
    const Wide twice = Wide(points[bundle.from]) + Wide(points[bundle.to]);
    int out = 0;
    // Counts the bundles that cross a ray from there to the right, a little above it.
    for (const Bundle& other : all) {
        const Wide a = std::int64_t{2} * Wide(points[other.from]),
                   b = std::int64_t{2} * Wide(points[other.to]);
        if ((a.y > twice.y) == (b.y > twice.y)) continue;
        if (&other == &bundle || turn_of(a, b, twice) > 0) out += other.net();
    }
    return out;
}

} // namespace

std::optional<LoopLayers> layers_of(const std::vector<std::vector<glm::ivec2>>& loops)
{
    CrossingWays crossing(loops);
    if (!crossing.cut_all()) return std::nullopt;
    LoopLayers out{crossing.points(), {}};
    for (const std::vector<std::uint32_t>& way : crossing.ways()) {
        std::vector<LoopLayers::Step>& steps = out.edges.emplace_back();
        for (std::size_t k = 0; k + 1 < way.size(); ++k) steps.push_back({way[k], way[k + 1], 0});
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    std::vector<Bundle> bundles;
    for (std::vector<LoopLayers::Step>& steps : out.edges)
        for (LoopLayers::Step& step : steps) {
            const glm::ivec2 a = out.points[step.from], b = out.points[step.to];
            const bool there = a.y < b.y || (a.y == b.y && a.x < b.x);
            const std::uint32_t from = there ? step.from : step.to;
            const std::uint32_t to = there ? step.to : step.from;
            const auto [found, is_new] = known.try_emplace({from, to}, bundles.size());
            if (is_new) bundles.push_back({from, to, {}, {}});
            Bundle& bundle = bundles[found->second];
            (there ? bundle.there : bundle.back).push_back(&step);
        }
    for (const Bundle& bundle : bundles) {
        const int net = bundle.net();
        if (net == 0) continue;
        const int left = winding_left_of(bundle, bundles, out.points);
        // On the left of those that are more, it is wound round so many times more
        const std::vector<LoopLayers::Step*>& more = net > 0 ? bundle.there : bundle.back;
        const int least = net > 0 ? left - net : left;
        for (int k = 0; k < std::abs(net); ++k) {
            const int winding = least + 1 + k; // on its left
            more[static_cast<std::size_t>(k)]->layer = winding > 0 ? winding : winding - 1;
        }
    }
    return out;
}

} // namespace trivar
