// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/silhouette_curves.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/polish.h"

#include <cmath>
#include <memory>

namespace trivar {

namespace {

constexpr std::size_t edges_ahead = 16; // whose vertices are on their way from memory

inline glm::vec3 zero_between(const glm::vec3& a, const glm::vec3& b, float product_a,
                              float product_b)
{
    float t = product_a / (product_a - product_b);
    if (!(t >= 0 && t <= 1)) t = 0.5f;
    return a + t * (b - a);
}

float squared_distance(const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 way = b - a;
    return glm::dot(way, way);
}

} // namespace

glm::vec3 place_on_edge(const glm::vec3& a, const glm::vec3& b, float product_a, float product_b)
{
    return zero_between(a, b, product_a, product_b);
}

Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> positions,
                      std::span<const float> product, float spacing)
{
    const std::vector<std::uint64_t>& edges = chains.edges;
    const auto places = std::make_unique_for_overwrite<glm::vec3[]>(edges.size());
    const auto ask_for = [&](std::uint64_t vertex) {
        __builtin_prefetch(positions.data() + vertex);
        __builtin_prefetch(product.data() + vertex);
    };
    parallel_blocks(edges.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint64_t later = edges[std::min(k + edges_ahead, end - 1)];
            ask_for(later >> 32);
            ask_for(later & 0xFFFFFFFF);
            const auto a = static_cast<std::size_t>(edges[k] >> 32),
                       b = static_cast<std::size_t>(edges[k] & 0xFFFFFFFF);
            places[k] = zero_between(positions[a], positions[b], product[a], product[b]);
        }
    });
    return curves_of(chains, std::span(places.get(), edges.size()), spacing);
}

Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> places, float spacing)
{
    Silhouettes out;
    std::vector<std::uint32_t> kept;
    for (std::size_t c = 0; c < chains.count(); ++c) {
        const std::uint32_t begin = chains.first[c], end = chains.first[c + 1],
                            length = end - begin;
        const std::size_t before = kept.size();
        kept.push_back(begin);
        glm::vec3 last = places[begin];
        for (std::uint32_t k = begin + 1; k < end; ++k)
            if (squared_distance(last, places[k]) >= spacing * spacing) {
                kept.push_back(k);
                last = places[k];
            }
        if (!chains.closed[c] && kept.back() + 1 != end) kept.push_back(end - 1);
        if (chains.closed[c] && kept.size() - before < 3 && length >= 3) {
            kept.resize(before);
            kept.insert(kept.end(), {begin, begin + length / 3, begin + 2 * length / 3});
        }
        out.first.push_back(static_cast<std::uint32_t>(kept.size()));
    }
    out.closed = chains.closed;
    out.points.resize(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        out.points[i].p = places[kept[i]];
        out.points[i].edge = chains.edges[kept[i]];
    }
    return out;
}

void finish(const ScalarField<float>& field, float level, const ViewPoint& view,
            const SilhouetteOptions& options, Silhouettes& out)
{
    parallel_blocks(out.points.size(), 256, [&](std::size_t begin, std::size_t end) {
        finish(field, level, view, options.polished,
               std::span(out.points).subspan(begin, end - begin));
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
