// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/ray_grid.h"

#include "core/base/mistake.h"
#include "core/placement/obstacle.h"
#include "core/placement/springs.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Computes the distance to the nearest hit in grid steps, ring by ring.
std::vector<double> nearest_hits(const RayGrid& grid)
{
    std::vector<double> distance = grid.distance;
    std::vector<char> known = grid.hit;
    for (bool more = true; more;) {
        more = false;
        const std::vector<char> before = known;
        for (int i = 0; i < grid.rows; ++i)
            for (int j = 0; j < grid.columns; ++j) {
                const std::size_t k = grid.index(i, j);
                if (before[k]) continue;
                double sum = 0;
                int count = 0;
                for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                    const int ni = i + di, nj = j + dj;
                    if (ni < 0 || nj < 0 || ni >= grid.rows || nj >= grid.columns) continue;
                    const std::size_t n = grid.index(ni, nj);
                    if (!before[n]) continue;
                    sum += distance[n];
                    ++count;
                }
                if (count == 0) continue;
                distance[k] = sum / count;
                known[k] = 1;
                more = true;
            }
    }
    return distance;
}

// Makes u harmonic on the misses: the mean of its four neighbours (fewer at the rim).
std::vector<double> membrane(const RayGrid& grid, std::vector<double> start)
{
    ObstacleProblem p = grid_laplacian(grid.rows, grid.columns);
    for (std::size_t k = 0; k < p.size(); ++k) p.free[k] = !grid.hit[k];
    const double scale = *std::max_element(start.begin(), start.end());
    return projected_sor(p, std::move(start), red_black(grid.rows, grid.columns),
                         over_relaxation(grid.rows, grid.columns), 1e-12 * scale, 4000)
        .s;
}

} // namespace

double RayGrid::missed_share() const
{
    const auto hits = std::count(hit.begin(), hit.end(), 1);
    return 1 - static_cast<double>(hits) / static_cast<double>(hit.size());
}

RayGrid shoot(const Strip& strip, std::vector<double> a, std::vector<double> v,
              const Camera& camera, const RayScene& scene, bool skip_back_faces)
{
    RayGrid grid;
    grid.rows = static_cast<int>(a.size());
    grid.columns = static_cast<int>(v.size() / a.size());
    grid.a = std::move(a);
    grid.v = std::move(v);
    const std::size_t n = grid.v.size();
    const auto columns = static_cast<std::size_t>(grid.columns);
    grid.rays.resize(n);
    const View view(camera);
    for (std::size_t i = 0; i < grid.a.size(); ++i) {
        const Strip::Ruling across = strip.ruling(grid.a[i]);
        for (std::size_t k = i * columns; k < (i + 1) * columns; ++k)
            grid.rays[k] = view.ray(across.at(grid.v[k]));
    }
    return met(std::move(grid), scene, skip_back_faces);
}

RayGrid met(RayGrid grid, const RayScene& scene, bool skip_back_faces)
{
    const std::size_t n = grid.rays.size();
    const std::vector<std::optional<Hit>> hits = scene.hits(grid.rays, skip_back_faces);
    grid.distance.assign(n, 0);
    grid.hit.assign(n, 0);
    grid.normal.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
        const glm::dvec3 d = grid.rays[k].direction;
        grid.normal[k] = -d;
        if (!hits[k] || std::abs(glm::dot(hits[k]->normal, d)) < grazing) continue;
        grid.hit[k] = 1;
        grid.distance[k] = hits[k]->distance;
        grid.normal[k] = hits[k]->back_face ? -hits[k]->normal : hits[k]->normal;
    }
    return grid;
}

RayGrid filled(RayGrid grid, Misses misses)
{
    const auto hits = static_cast<std::size_t>(std::count(grid.hit.begin(), grid.hit.end(), 1));
    ensure(hits > 0, "no ray hits anything");
    if (hits == grid.hit.size()) return grid;
    RayGrid known = grid;
    if (misses == Misses::ground)
        for (std::size_t k = 0; k < grid.rays.size(); ++k) {
            const Ray& ray = grid.rays[k];
            const double t = -ray.origin.z / ray.direction.z;
            if (known.hit[k] || !(std::isfinite(t) && t > 0)) continue;
            known.distance[k] = t;
            known.hit[k] = 1;
        }
    std::vector<double> nearest = nearest_hits(known);
    grid.distance =
        misses == Misses::nearest ? std::move(nearest) : membrane(known, std::move(nearest));
    return grid;
}

} // namespace trivar
