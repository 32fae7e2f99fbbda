// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tiles/surface_maps.h"

#include "core/tiles/texture_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace trivar::testing {
namespace {

std::int64_t distance2(int a, int b, int size)
{
    const std::int64_t x = a % size - b % size, y = a / size - b / size;
    return x * x + y * y;
}

// The value between the centres of texels; beyond the outermost ones theirs.
glm::dvec3 between(const std::vector<glm::dvec3>& values, int size, const glm::dvec2& uv)
{
    const glm::dvec2 at = glm::clamp(uv * double(size) - 0.5, 0.0, size - 1.0);
    const int i = std::min(int(at.x), size - 2), j = std::min(int(at.y), size - 2);
    const double x = at.x - i, y = at.y - j;
    const auto value = [&](int a, int b) { return values[std::size_t(size) * b + a]; };
    return glm::mix(glm::mix(value(i, j), value(i + 1, j), x),
                    glm::mix(value(i, j + 1), value(i + 1, j + 1), x), y);
}

} // namespace

SurfaceMaps surface_maps(const Mesh& mesh, int size)
{
    SurfaceMaps out;
    out.size = size;
    const auto texels = std::size_t(size) * size;
    for (auto* map : {&out.p, &out.normal, &out.along_u, &out.along_v})
        map->assign(texels, glm::dvec3(0));
    out.inside.assign(texels, 0);
    const std::vector<glm::uvec3> all = triangles(mesh);
    const std::optional<TextureSpots> centres =
        texture_spots(mesh, glm::dmat4(1), size, size, std::numeric_limits<std::size_t>::max());
    for (const TextureSpot& spot : centres->spots) {
        if (spot.cell.x < 0 || spot.cell.y < 0 || spot.cell.x >= size || spot.cell.y >= size)
            continue;
        const auto texel = std::size_t(spot.cell.y * size + spot.cell.x);
        const glm::uvec3& t = all[spot.triangle];
        glm::dvec3 n(0);
        for (int k = 0; k < 3; ++k) n += spot.weights[k] * glm::dvec3(mesh.normals[t[k]]);
        out.p[texel] = spot.p;
        out.normal[texel] = glm::normalize(n);
        out.along_u[texel] = spot.along_u * double(size);
        out.along_v[texel] = spot.along_v * double(size);
        out.inside[texel] = 1;
    }
    return out;
}

std::vector<int> flooded(const std::vector<char>& inside, int size)
{
    std::vector<int> nearest(inside.size(), -1), before;
    for (int k = 0; k < int(inside.size()); ++k)
        if (inside[std::size_t(k)]) nearest[std::size_t(k)] = k;
    std::vector<int> steps{1};
    for (int step = int(std::bit_floor(unsigned(std::max(size - 1, 1)))); step > 0; step /= 2)
        steps.push_back(step);
    for (const int step : steps) {
        before = nearest;
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                int& best = nearest[std::size_t(j * size + i)];
                for (int y = j - step; y <= j + step; y += step)
                    for (int x = i - step; x <= i + step; x += step) {
                        if (x < 0 || y < 0 || x >= size || y >= size) continue;
                        const int other = before[std::size_t(y * size + x)], here = j * size + i;
                        if (other >= 0 &&
                            (best < 0 || std::pair(distance2(other, here, size), other) <
                                             std::pair(distance2(best, here, size), best)))
                            best = other;
                    }
            }
    }
    return nearest;
}

SurfaceMaps extended(const SurfaceMaps& maps, Extension how)
{
    SurfaceMaps out = maps;
    const std::vector<int> nearest = flooded(maps.inside, maps.size);
    for (std::size_t k = 0; k < out.p.size(); ++k) {
        if (maps.inside[k] || nearest[k] < 0) continue;
        const auto q = std::size_t(nearest[k]);
        out.p[k] = maps.p[q];
        out.normal[k] = maps.normal[q];
        if (how == Extension::nearest) continue;
        const int here = int(k);
        out.p[k] +=
            maps.along_u[q] * (double(here % maps.size - nearest[k] % maps.size) / maps.size) +
            maps.along_v[q] * (double(here / maps.size - nearest[k] / maps.size) / maps.size);
    }
    return out;
}

std::vector<double> valid_shares(const SurfaceMaps& maps, int columns)
{
    std::vector<double> valid(std::size_t(columns) * columns, 0), all = valid;
    for (int j = 0; j < maps.size; ++j)
        for (int i = 0; i < maps.size; ++i) {
            const auto cell =
                std::size_t(j * columns / maps.size * columns + i * columns / maps.size);
            ++all[cell];
            valid[cell] += maps.inside[std::size_t(j * maps.size + i)];
        }
    for (std::size_t k = 0; k < all.size(); ++k) valid[k] /= std::max(all[k], 1.0);
    return valid;
}

TilePatch cell_patch(const SurfaceMaps& maps, int columns, int i, int j)
{
    TilePatch out;
    for (std::size_t k = 0; k < 16; ++k) {
        const glm::dvec2 uv =
            glm::dvec2(i + patch_nodes[k % 4], j + patch_nodes[k / 4]) / double(columns);
        out.p[k] = between(maps.p, maps.size, uv);
        out.n[k] = glm::normalize(between(maps.normal, maps.size, uv));
    }
    return {through_nodes(out.p), through_nodes(out.n)};
}

} // namespace trivar::testing
