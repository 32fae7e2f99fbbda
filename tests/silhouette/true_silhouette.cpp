// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/silhouette/true_silhouette.h"

#include "core/base/parallel.h"
#include "core/silhouette/polish.h"

#include <cmath>
#include <map>
#include <tuple>

namespace trivar::testing {
namespace {

constexpr int per_voxel = 8;

// Whether the linear part of both functions may vanish within a box round its middle, with room for
// what bends.
bool may_be_near(const ScalarField<double>& field, double level, const ViewPoint& view,
                 const glm::dvec3& p)
{
    const ScalarJet<double> jet = field.at<2>(p);
    const glm::dvec3 g(jet.gradient[0], jet.gradient[1], jet.gradient[2]);
    constexpr double radius = 2.0 / per_voxel;
    return std::abs(jet.value - level) <= radius * glm::length(g) + 0.02 &&
           std::abs(glm::dot(view.sight(p), g)) <= 2 * glm::length(g) * glm::length(view.sight(p));
}

double distance_to(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0 ? glm::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * along);
}

} // namespace

std::vector<glm::dvec3> true_silhouette(const ScalarField<double>& field, double level,
                                        const ViewPoint& view)
{
    const glm::ivec3 count = (field.size() - 1) * per_voxel;
    std::vector<std::vector<glm::dvec3>> by_layer(static_cast<std::size_t>(count.z));
    parallel_blocks(by_layer.size(), 1, [&](std::size_t layer, std::size_t) {
        for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i) {
                const glm::dvec3 lo =
                    glm::dvec3(i, j, static_cast<double>(layer)) / double{per_voxel};
                glm::dvec3 p = lo + 0.5 / per_voxel;
                if (!may_be_near(field, level, view, p)) continue;
                ScalarJet<double> jet;
                if (!polish(field, level, view, p, jet, 1e-9)) continue;
                if (glm::all(glm::greaterThanEqual(p, lo)) &&
                    glm::all(glm::lessThan(p, lo + 1.0 / per_voxel)))
                    by_layer[layer].push_back(p);
            }
    });
    std::vector<glm::dvec3> out;
    for (const std::vector<glm::dvec3>& each : by_layer)
        out.insert(out.end(), each.begin(), each.end());
    return out;
}

double share_near(const std::vector<glm::dvec3>& places, const Silhouettes& curves, double distance)
{
    using Cell = std::tuple<int, int, int>;
    const auto cell_of = [](const glm::dvec3& p) { return glm::ivec3(glm::floor(p)); };
    std::map<Cell, std::vector<std::pair<glm::dvec3, glm::dvec3>>> segments;
    for (std::size_t c = 0; c < curves.count(); ++c)
        for (std::uint32_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const bool last = i + 1 == curves.first[c + 1];
            if (last && !curves.closed[c]) continue;
            const glm::dvec3 a(curves.points[i].p),
                b(curves.points[last ? curves.first[c] : i + 1].p);
            const glm::ivec3 lo = cell_of(glm::min(a, b) - distance),
                             hi = cell_of(glm::max(a, b) + distance);
            for (int z = lo.z; z <= hi.z; ++z)
                for (int y = lo.y; y <= hi.y; ++y)
                    for (int x = lo.x; x <= hi.x; ++x) segments[{x, y, z}].emplace_back(a, b);
        }
    std::size_t near = 0;
    for (const glm::dvec3& p : places) {
        const glm::ivec3 cell = cell_of(p);
        const auto at = segments.find({cell.x, cell.y, cell.z});
        near += at != segments.end() && std::ranges::any_of(at->second, [&](const auto& s) {
                    return distance_to(p, s.first, s.second) <= distance;
                });
    }
    return places.empty() ? 1 : static_cast<double>(near) / static_cast<double>(places.size());
}

} // namespace trivar::testing
