// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/chart_uvs.h"

#include <algorithm>

namespace trivar {
namespace {

// The point at which all charts of a face meet, of which there is one for each of its corners.
std::uint32_t middle_point(const ChartNet& net, std::uint32_t first, std::uint32_t count)
{
    for (const std::uint32_t point : net.chart(first).points) {
        bool all = true;
        for (std::uint32_t c = first + 1; c < first + count; ++c)
            all = all && std::ranges::find(net.chart(c).points, point) != net.chart(c).points.end();
        if (all) return point;
    }
    return net.chart(first).points[2];
}

} // namespace

ChartUvs chart_uvs(const ChartNet& net, const Cage& cage, std::span<const glm::dvec2> corner_uvs)
{
    ChartUvs out(net.size());
    const bool whole = net.size() == cage.face_sizes.size();
    std::size_t first = 0;
    std::uint32_t chart = 0;
    for (const int size : cage.face_sizes) {
        const auto n = static_cast<std::size_t>(size);
        const std::span<const glm::dvec2> uvs = corner_uvs.subspan(first, n);
        if (whole) {
            for (std::size_t k = 0; k < 4; ++k) {
                std::size_t corner = k;
                for (std::size_t i = 0; n != 4 && i < n; ++i) // a triangle, from its pole on
                    if (static_cast<std::uint32_t>(cage.corners[first + i]) ==
                        net.chart(chart).points[k])
                        corner = i;
                out[chart][k] = uvs[std::min(corner, n - 1)];
            }
            ++chart;
        } else {
            // One chart for each corner, from that over the middle of an edge to the face's.
            glm::dvec2 sum(0);
            for (const glm::dvec2& each : uvs) sum += each;
            const std::uint32_t all = middle_point(net, chart, static_cast<std::uint32_t>(n));
            for (std::size_t k = 0; k < n; ++k, ++chart) {
                const auto& points = net.chart(chart).points;
                const auto middle =
                    static_cast<std::size_t>(std::ranges::find(points, all) - points.begin());
                out[chart][(middle + 2) % 4] = uvs[k];
                out[chart][(middle + 3) % 4] = 0.5 * (uvs[k] + uvs[(k + 1) % n]);
                out[chart][middle % 4] = sum / static_cast<double>(n);
                out[chart][(middle + 1) % 4] = 0.5 * (uvs[(k + n - 1) % n] + uvs[k]);
            }
        }
        first += n;
    }
    return out;
}

} // namespace trivar
