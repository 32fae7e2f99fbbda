// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/filled_triangles.h"

#include <algorithm>
#include <set>

namespace trivar {
namespace {

// Returns the triangles connected with those of the path across their sides.
std::vector<std::uint32_t> connected(const TileBase& base, const std::vector<StrokeStep>& path)
{
    std::vector<char> seen(base.triangle_count(), 0);
    std::vector<std::uint32_t> out;
    for (const StrokeStep& each : path)
        if (!seen[each.at.triangle]) {
            seen[each.at.triangle] = 1;
            out.push_back(each.at.triangle);
        }
    for (std::size_t i = 0; i < out.size(); ++i)
        for (int e = 0; e < 3; ++e) {
            const std::uint32_t behind = base.across(out[i], e);
            if (behind == TileBase::none || seen[behind / 3]) continue;
            seen[behind / 3] = 1;
            out.push_back(behind / 3);
        }
    std::ranges::sort(out);
    return out;
}

} // namespace

std::vector<std::uint32_t> filled_triangles(const TileBase& base, TileArea area,
                                            const std::vector<StrokeStep>& path)
{
    if (area == TileArea::island) return connected(base, path);
    const auto mark = [&](std::uint32_t t) {
        return area == TileArea::material ? base.material_of(t) : base.face_of(t);
    };
    std::set<std::uint32_t> touched;
    for (const StrokeStep& each : path) touched.insert(mark(each.at.triangle));
    std::vector<std::uint32_t> out;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t)
        if (area == TileArea::all || touched.contains(mark(t))) out.push_back(t);
    return out;
}

} // namespace trivar
