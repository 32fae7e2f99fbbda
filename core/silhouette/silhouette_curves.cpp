// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/silhouette_curves.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/polish.h"

#include <cmath>

namespace trivar {

Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> positions,
                      std::span<const float> product, float spacing)
{
    const auto point = [&](std::uint32_t k) {
        const std::uint64_t edge = chains.edges[k];
        const auto a = static_cast<std::size_t>(edge >> 32),
                   b = static_cast<std::size_t>(edge & 0xFFFFFFFF);
        float t = product[a] / (product[a] - product[b]);
        if (!(t >= 0 && t <= 1)) t = 0.5f;
        return SilhouettePoint{.p = positions[a] + t * (positions[b] - positions[a]), .edge = edge};
    };
    Silhouettes out;
    for (std::size_t c = 0; c < chains.count(); ++c) {
        const std::uint32_t begin = chains.first[c], end = chains.first[c + 1];
        const std::size_t before = out.points.size();
        for (std::uint32_t k = begin; k < end; ++k) {
            const SilhouettePoint next = point(k);
            const bool stays = k == begin || (!chains.closed[c] && k + 1 == end);
            if (!stays && glm::distance(next.p, out.points.back().p) < spacing) continue;
            out.points.push_back(next);
        }
        const std::uint32_t length = end - begin;
        if (chains.closed[c] && out.points.size() - before < 3 && length >= 3) {
            out.points.resize(before);
            for (std::uint32_t e = 0; e < 3; ++e)
                out.points.push_back(point(begin + e * length / 3));
        }
        out.first.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.closed.push_back(chains.closed[c]);
    }
    return out;
}

void finish(const ScalarField<float>& field, float level, const ViewPoint& view,
            const SilhouetteOptions& options, Silhouettes& out)
{
    parallel_blocks(out.points.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            finish(field, level, view, options.polished, out.points[i]);
    });
}

bool are_in_a_face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& end)
{
    for (int k = 0; k < 3; ++k)
        if ((a[k] == 0 && b[k] == 0) || (a[k] == end[k] && b[k] == end[k])) return true;
    return false;
}

void check(const ViewPoint& view)
{
    if (!std::isfinite(glm::dot(view.at, view.at)) || view.at == glm::dvec4(0))
        throw Rejected("a view needs a direction or an eye");
}

} // namespace trivar
