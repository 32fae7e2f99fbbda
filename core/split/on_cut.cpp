// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/on_cut.h"

#include "core/base/joined_sets.h"
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

enum Uses : char { by_none, by_below, by_above, by_both };

} // namespace

SidesOnCut sides_on_cut(const Mesh& mesh, std::span<const double> heights, const OnCut& on)
{
    const auto is_on = [&](std::uint32_t v) { return std::abs(heights[v]) <= on.within; };
    const auto corners = [&](std::size_t f) {
        return std::span(mesh.corners.data() + mesh.face_begin[f],
                         mesh.corners.data() + mesh.face_begin[f + 1]);
    };
    const std::size_t points = point_count(mesh);
    SidesOnCut out;
    std::vector<std::uint32_t> lying; // faces all of which lie on the cut
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        char uses = by_none;
        for (const std::uint32_t v : corners(f))
            if (!is_on(v)) uses |= heights[v] > 0 ? by_above : by_below;
        if (uses == by_none) lying.push_back(f);
        out.sides.push_back(uses == by_both    ? side_across
                            : uses == by_below ? side_below
                                               : side_above);
    }
    if (!lying.empty()) {
        JoinedSets bodies(points);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (const std::uint32_t v : corners(f))
                bodies.join(mesh.point(corners(f)[0]), mesh.point(v));
        std::vector<char> off(points, by_none); // where a body has vertices off the cut
        for (std::uint32_t v = 0; v < heights.size(); ++v)
            if (!is_on(v)) off[bodies.root(mesh.point(v))] |= heights[v] > 0 ? by_above : by_below;
        const bool closed = Adjacency(mesh).is_closed();
        for (const std::uint32_t f : lying) {
            const char body = off[bodies.root(mesh.point(corners(f)[0]))];
            const glm::dvec3 p(mesh.positions[corners(f)[0]]);
            const bool looks_up = glm::dot(area_normal(mesh, f), on.up(p)) > 0;
            // A sheet has no solid under it that would say more than where it goes on
            const bool by_normal = body == by_both || (closed && body != by_none);
            out.sides[f] = (by_normal ? looks_up : body == by_below) ? side_below : side_above;
        }
    }
    std::vector<char> used(points, by_none);
    for (std::size_t f = 0; f < out.sides.size(); ++f)
        for (const std::uint32_t v : corners(f))
            if (is_on(v))
                used[mesh.point(v)] |= out.sides[f] == side_across  ? by_both
                                       : out.sides[f] == side_above ? by_above
                                                                    : by_below;
    for (std::uint32_t v = 0; v < heights.size(); ++v) {
        const char by = is_on(v)         ? used[mesh.point(v)]
                        : heights[v] > 0 ? char{by_above}
                                         : char{by_below};
        out.both.push_back(by == by_both);
        out.above.push_back(by >= by_above);
    }
    for (std::uint32_t f = 0; f < out.sides.size(); ++f)
        if (out.sides[f] == side_across)
            out.across.push_back(f);
        else if (std::ranges::any_of(corners(f), [&](std::uint32_t v) { return out.both[v] != 0; }))
            out.beside.push_back(f);
    return out;
}

} // namespace trivar
