// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/stroke_ends.h"

#include "core/base/key_numbers.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float facing = -0.5f; // cosine between the directions out of two ends
constexpr std::size_t points_of_direction = 2;

// An end is 2 s for the first point of stroke s, and 2 s + 1 for its last.
struct StrokeEnd {
    std::size_t end;
    glm::vec2 at, outward;
    bool hidden;
};

struct EndPair {
    float cost;
    std::size_t a, b; // in the list of ends
};

std::vector<StrokeEnd> loose_ends(const std::vector<Stroke>& strokes)
{
    std::vector<StrokeEnd> out;
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        const std::vector<StrokePoint>& p = strokes[s].points;
        if (p.size() < 2 || strokes[s].is_loop()) continue;
        const std::size_t inward = std::min(points_of_direction, p.size() - 1);
        const auto add = [&](std::size_t end, const glm::vec2& at, const glm::vec2& from) {
            const float length = glm::distance(at, from);
            out.push_back(
                {end, at, length > 0 ? (at - from) / length : glm::vec2(0), strokes[s].hidden});
        };
        add(2 * s, p.front().at, p[inward].at);
        add(2 * s + 1, p.back().at, p[p.size() - 1 - inward].at);
    }
    return out;
}

// EndCells finds numbers by places in the image that are within a reach.
class EndCells {
public:
    EndCells(std::size_t about, float reach) : reach_(reach), numbers_(about) {}
    void add(const glm::vec2& at, std::size_t number)
    {
        const auto [cell, is_new] = numbers_.number(key(at, {0, 0}));
        if (is_new) cells_.emplace_back();
        cells_[cell].push_back({at, number});
    }
    // Calls use(number, distance) for each number within the reach.
    void near(const glm::vec2& at, auto&& use) const
    {
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const std::uint32_t cell = numbers_.find(key(at, {x, y}));
                if (cell == KeyNumbers::none) continue;
                for (const Entry& entry : cells_[cell])
                    if (const float distance = glm::distance(at, entry.at); distance <= reach_)
                        use(entry.number, distance);
            }
    }

private:
    struct Entry {
        glm::vec2 at;
        std::size_t number;
    };
    std::uint64_t key(const glm::vec2& at, const glm::ivec2& beside) const
    {
        const glm::vec2 place = glm::clamp(at / reach_, -1e9f, 1e9f); // far where near the eye
        const glm::ivec2 cell = glm::ivec2(glm::floor(place)) + beside;
        return pair_key(static_cast<std::uint32_t>(cell.x), static_cast<std::uint32_t>(cell.y));
    }
    float reach_;
    KeyNumbers numbers_;
    std::vector<std::vector<Entry>> cells_;
};

std::vector<EndPair> facing_pairs(const std::vector<StrokeEnd>& ends, float reach)
{
    EndCells cells(ends.size(), reach);
    std::vector<EndPair> out;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        cells.near(ends[i].at, [&](std::size_t j, float distance) {
            const float cosine = glm::dot(ends[i].outward, ends[j].outward);
            if (cosine <= facing && ends[i].hidden == ends[j].hidden)
                out.push_back({distance + 0.5f * reach * (1 + cosine), j, i});
        });
        cells.add(ends[i].at, i);
    }
    std::ranges::stable_sort(out, {}, &EndPair::cost);
    return out;
}

} // namespace

std::vector<Stroke> joined(std::vector<Stroke> strokes, float reach)
{
    constexpr std::size_t none = ~std::size_t{0};
    const std::vector<StrokeEnd> ends = loose_ends(strokes);
    std::vector<std::size_t> mate(2 * strokes.size(), none); // by end
    for (const EndPair& pair : facing_pairs(ends, reach)) {
        const std::size_t a = ends[pair.a].end, b = ends[pair.b].end;
        if (mate[a] != none || mate[b] != none) continue;
        mate[a] = b;
        mate[b] = a;
    }
    std::vector<Stroke> out;
    std::vector<char> done(strokes.size(), 0);
    const auto follow = [&](std::size_t end) {
        Stroke whole = strokes[end / 2];
        whole.points.clear();
        whole.tapers_first = mate[end] == none && strokes[end / 2].tapers_first;
        while (true) {
            Stroke& piece = strokes[end / 2];
            if (done[end / 2]) { // a loop
                whole.points.push_back(whole.points.front());
                whole.tapers_first = whole.tapers_last = false;
                break;
            }
            done[end / 2] = 1;
            if (end % 2) std::ranges::reverse(piece.points);
            whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
            whole.id = std::min(whole.id, piece.id);
            whole.tapers_last = end % 2 ? piece.tapers_first : piece.tapers_last;
            const std::size_t next = mate[end ^ 1];
            if (next == none) break;
            end = next;
        }
        out.push_back(std::move(whole));
    };
    for (std::size_t end = 0; end < mate.size(); ++end)
        if (!done[end / 2] && mate[end] == none) follow(end);
    for (std::size_t s = 0; s < strokes.size(); ++s)
        if (!done[s]) follow(2 * s);
    return out;
}

void hold_ends(std::span<Stroke* const> strokes, float reach)
{
    EndCells cells(2 * strokes.size(), reach);
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        if (strokes[s]->points.empty() || strokes[s]->is_loop()) continue;
        cells.add(strokes[s]->points.front().at, 2 * s);
        cells.add(strokes[s]->points.back().at, 2 * s + 1);
    }
    for (std::size_t s = 0; s < strokes.size(); ++s)
        for (const StrokePoint& p : strokes[s]->points)
            cells.near(p.at, [&](std::size_t end, float) {
                Stroke& other = *strokes[end / 2];
                if (end / 2 == s || (strokes[s]->hidden && !other.hidden)) return;
                (end % 2 ? other.tapers_last : other.tapers_first) = false;
            });
}

} // namespace trivar
