// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plane/loops.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

namespace trivar {
namespace {

ClipperLib::Paths paths_of(const Region& region)
{
    ClipperLib::Paths paths;
    for (const Loop& loop : region) {
        ClipperLib::Path& path = paths.emplace_back();
        for (const glm::ivec2& p : loop) path.emplace_back(p.x, p.y);
    }
    return paths;
}

Region region_of(const ClipperLib::Paths& paths)
{
    Region region;
    for (const ClipperLib::Path& path : paths) {
        if (path.size() < 3) continue;
        Loop& loop = region.emplace_back();
        for (const ClipperLib::IntPoint& p : path)
            loop.emplace_back(static_cast<int>(p.X), static_cast<int>(p.Y));
    }
    return region;
}

} // namespace

Region united(const Region& loops, bool even_odd)
{
    ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
    clipper.AddPaths(paths_of(loops), ClipperLib::ptSubject, true);
    ClipperLib::Paths result;
    const ClipperLib::PolyFillType fill =
        even_odd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    clipper.Execute(ClipperLib::ctUnion, result, fill, fill);
    return region_of(result);
}

Region inset(const Region& region, double distance)
{
    constexpr double longest_spike = 4; // at a reflex corner, in distances
    ClipperLib::ClipperOffset offset(longest_spike);
    offset.AddPaths(paths_of(region), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    offset.Execute(result, -distance);
    return region_of(result);
}

Region with_short_edges(const Region& region, double longest)
{
    Region result;
    for (const Loop& loop : region) {
        Loop& cut = result.emplace_back();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a(loop[i]), b(loop[(i + 1) % loop.size()]);
            const int parts =
                std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / longest)));
            for (int k = 0; k < parts; ++k)
                cut.emplace_back(glm::round(a + (b - a) * (double(k) / parts)));
        }
    }
    return result;
}

} // namespace trivar
