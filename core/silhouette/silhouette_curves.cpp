// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/silhouette_curves.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/polish.h"

#include <cmath>

namespace trivar {

glm::vec3 place_on_edge(const glm::vec3& a, const glm::vec3& b, float product_a, float product_b)
{
    float t = product_a / (product_a - product_b);
    if (!(t >= 0 && t <= 1)) t = 0.5f;
    return a + t * (b - a);
}

namespace {

// Where the product is 0 on each edge.
std::vector<glm::vec3> places_on(std::span<const std::uint64_t> edges,
                                 std::span<const glm::vec3> positions,
                                 std::span<const float> product)
{
    std::vector<glm::vec3> out(edges.size());
    parallel_blocks(edges.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto a = static_cast<std::size_t>(edges[k] >> 32),
                       b = static_cast<std::size_t>(edges[k] & 0xFFFFFFFF);
            out[k] = place_on_edge(positions[a], positions[b], product[a], product[b]);
        }
    });
    return out;
}

float squared_distance(const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 way = b - a;
    return glm::dot(way, way);
}

} // namespace

Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> positions,
                      std::span<const float> product, float spacing)
{
    return curves_of(chains, places_on(chains.edges, positions, product), spacing);
}

Silhouettes curves_of(const EdgeChains& chains, std::span<const glm::vec3> places, float spacing)
{
    Silhouettes out;
    std::vector<std::uint32_t> kept; // of a chain
    for (std::size_t c = 0; c < chains.count(); ++c) {
        const std::uint32_t begin = chains.first[c], end = chains.first[c + 1],
                            length = end - begin;
        kept.assign(1, begin);
        for (std::uint32_t k = begin + 1; k < end; ++k)
            if (squared_distance(places[kept.back()], places[k]) >= spacing * spacing)
                kept.push_back(k);
        if (!chains.closed[c] && kept.back() + 1 != end) kept.push_back(end - 1);
        if (chains.closed[c] && kept.size() < 3 && length >= 3)
            kept = {begin, begin + length / 3, begin + 2 * length / 3};
        for (const std::uint32_t k : kept)
            out.points.push_back({.p = places[k], .edge = chains.edges[k]});
        out.first.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.closed.push_back(chains.closed[c]);
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
