// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/seen_part.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double most_pixels = 65'536;

bool can_be_shown(const glm::dvec4& q)
{
    return q.w > 0 && q.z >= 0 && std::abs(q.x) <= most_pixels * q.w &&
           std::abs(q.y) <= most_pixels * q.w;
}

} // namespace

std::optional<SeenPart> seen_part(const Silhouettes& silhouettes, const std::vector<char>& hidden,
                                  const glm::dmat4& to_image)
{
    const auto is_shown = [&](const SilhouettePoint& point) {
        return can_be_shown(to_image * glm::dvec4(glm::dvec3(point.p), 1));
    };
    if (std::ranges::all_of(silhouettes.points, is_shown)) return std::nullopt;
    SeenPart out;
    std::size_t begin = 0;
    const auto end_curve = [&](bool closed) {
        std::vector<SilhouettePoint>& points = out.curves.points;
        if (points.size() < begin + 2) points.resize(begin);
        out.hidden.resize(points.size());
        if (points.size() == begin) return;
        begin = points.size();
        out.curves.first.push_back(static_cast<std::uint32_t>(begin));
        out.curves.closed.push_back(closed);
    };
    for (std::size_t c = 0; c < silhouettes.count(); ++c) {
        const std::uint32_t first = silhouettes.first[c], count = silhouettes.first[c + 1] - first;
        const auto at = [&](std::uint32_t i) { return first + i % count; };
        std::uint32_t start = 0; // of a loop that is cut: behind a cut
        if (silhouettes.closed[c])
            while (start < count && is_shown(silhouettes.points[at(start)])) ++start;
        const bool whole = silhouettes.closed[c] && start == count;
        if (whole) start = 0;
        for (std::uint32_t i = start; i < start + count; ++i) {
            const SilhouettePoint& point = silhouettes.points[at(i)];
            if (!is_shown(point)) {
                end_curve(false);
                continue;
            }
            out.curves.points.push_back(point);
            out.hidden.push_back(hidden[at(i)]);
        }
        end_curve(whole);
    }
    out.curves.tested = silhouettes.tested;
    out.curves.crossed = silhouettes.crossed;
    return out;
}

} // namespace trivar
