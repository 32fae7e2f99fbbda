// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/rim_loops.h"

#include <limits>

namespace trivar {
namespace {

constexpr std::uint32_t no_edge = 0xffffffff;
constexpr double most_gaps = 0.2; // of a loop

double signed_area(const RimLoop& loop, const std::vector<glm::dvec2>& places)
{
    const glm::dvec2 from = places[loop.front()];
    double sum = 0;
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
        const glm::dvec2 a = places[loop[i]] - from, b = places[loop[i + 1]] - from;
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}

bool winds_round(const RimLoop& loop, const std::vector<glm::dvec2>& places, const glm::dvec2& p)
{
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = places[loop[i]], b = places[loop[(i + 1) % loop.size()]];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

} // namespace

RimLoops loops_of(const std::vector<glm::uvec2>& edges, std::size_t places)
{
    // Edges that leave a place, as a list
    std::vector<std::uint32_t> first(places, no_edge), next(edges.size(), no_edge);
    std::vector<std::uint32_t> arriving(places, 0);
    for (std::size_t e = edges.size(); e-- > 0;) {
        next[e] = first[edges[e].x];
        first[edges[e].x] = static_cast<std::uint32_t>(e);
        ++arriving[edges[e].y];
    }
    std::vector<char> done(edges.size(), 0);
    const auto leaving = [&](std::uint32_t place) {
        std::uint32_t& e = first[place];
        while (e != no_edge && done[e]) e = next[e];
        return e;
    };
    RimLoops out;
    const auto walk = [&](std::uint32_t e) {
        const std::uint32_t start = edges[e].x;
        RimLoop way{start};
        while (e != no_edge) {
            done[e] = 1;
            const std::uint32_t at = edges[e].y;
            if (at == start) {
                out.closed.push_back(std::move(way));
                return;
            }
            way.push_back(at);
            e = leaving(at);
        }
        out.open.push_back(std::move(way));
    };
    // Open ways first, from where none arrives
    for (std::uint32_t p = 0; p < places; ++p)
        while (arriving[p] == 0) {
            const std::uint32_t e = leaving(p);
            if (e == no_edge) break;
            walk(e);
        }
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        if (!done[e]) walk(e);
    return out;
}

std::vector<RimLoop> joined_ways(const std::vector<RimLoop>& ways,
                                 const std::vector<glm::dvec2>& places)
{
    std::vector<RimLoop> out;
    std::vector<char> done(ways.size(), 0);
    for (std::size_t first = 0; first < ways.size(); ++first) {
        if (done[first]) continue;
        RimLoop loop;
        double length = 0, gaps = 0;
        for (std::size_t at = first;;) {
            done[at] = 1;
            for (std::size_t i = 0; i + 1 < ways[at].size(); ++i)
                length += glm::distance(places[ways[at][i]], places[ways[at][i + 1]]);
            loop.insert(loop.end(), ways[at].begin(), ways[at].end());
            std::size_t next = first;
            double least = glm::distance(places[ways[at].back()], places[ways[first].front()]);
            for (std::size_t k = 0; k < ways.size(); ++k) {
                const double distance =
                    glm::distance(places[ways[at].back()], places[ways[k].front()]);
                if (done[k] || distance >= least) continue;
                least = distance;
                next = k;
            }
            gaps += least;
            if (next == first) break;
            at = next;
        }
        if (gaps <= most_gaps * (length + gaps)) out.push_back(std::move(loop));
    }
    return out;
}

std::vector<std::vector<std::size_t>> nested(const std::vector<RimLoop>& loops,
                                             const std::vector<glm::dvec2>& places)
{
    std::vector<double> areas;
    for (const RimLoop& loop : loops) areas.push_back(signed_area(loop, places));
    std::vector<std::vector<std::size_t>> out;
    std::vector<std::size_t> group_of(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (areas[i] > 0) {
            group_of[i] = out.size();
            out.push_back({i});
        }
    for (std::size_t hole = 0; hole < loops.size(); ++hole) {
        if (areas[hole] > 0) continue;
        double least = std::numeric_limits<double>::infinity();
        std::size_t group = out.size();
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (areas[i] > -areas[hole] && areas[i] < least &&
                winds_round(loops[i], places, places[loops[hole].front()])) {
                least = areas[i];
                group = group_of[i];
            }
        if (group == out.size()) out.push_back({});
        out[group].push_back(hole);
    }
    return out;
}

} // namespace trivar
