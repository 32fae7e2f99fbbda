// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/needed_cut.h"

#include "core/base/joined_sets.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t most_loops = 512; // of more all are cut

struct NeededLoop {
    glm::dvec2 lo{1e300}, hi{-1e300}; // of its triangles
    bool cut = true;

    bool meets(const glm::dvec2& other_lo, const glm::dvec2& other_hi) const
    {
        return lo.x <= other_hi.x && other_lo.x <= hi.x && lo.y <= other_hi.y && other_lo.y <= hi.y;
    }
};

} // namespace

std::vector<char> needed(std::span<const glm::uvec3> across, const Mesh& mesh, const CutNeed& need)
{
    JoinedSets joined(mesh.points.empty() ? mesh.vertex_count() : point_count(mesh));
    for (const glm::uvec3& t : across)
        for (int i = 1; i < 3; ++i) joined.join(mesh.point(t[i]), mesh.point(t.x));
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> number; // of a loop, by the point that stands for its points
    std::vector<NeededLoop> loops;
    std::vector<std::uint32_t> loop_of;
    loop_of.reserve(across.size());
    for (const glm::uvec3& t : across) {
        const std::uint32_t root = joined.root(mesh.point(t.x));
        if (root >= number.size()) number.resize(root + std::size_t{1}, none);
        if (number[root] == none) {
            if (loops.size() == most_loops) return {};
            number[root] = static_cast<std::uint32_t>(loops.size());
            loops.emplace_back();
        }
        loop_of.push_back(number[root]);
        NeededLoop& loop = loops[number[root]];
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 at = need.at(t[i]);
            loop.lo = glm::min(loop.lo, at);
            loop.hi = glm::max(loop.hi, at);
        }
    }
    for (NeededLoop& loop : loops) loop.cut = loop.meets(need.over.lo, need.over.hi);
    for (bool changed = true; changed;) {
        changed = false;
        for (NeededLoop& loop : loops) {
            if (loop.cut || std::ranges::none_of(loops, [&](const NeededLoop& other) {
                    return other.cut && loop.meets(other.lo, other.hi);
                }))
                continue;
            loop.cut = changed = true;
        }
    }
    if (std::ranges::all_of(loops, &NeededLoop::cut)) return {};
    std::vector<char> out;
    out.reserve(across.size());
    for (const std::uint32_t loop : loop_of) out.push_back(loops[loop].cut);
    return out;
}

} // namespace trivar
