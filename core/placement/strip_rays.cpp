// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_rays.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double steep = 0.3; // cosine to the ray below which a cell gets more rays
constexpr std::size_t rays_a_block = 512;

struct Cell {
    glm::ivec2 at;
    int rays; // along each axis
};

// Returns the cosine between the surface and the line of sight.
double facing(const SurfaceTable& s, glm::dvec2 uv, const View& view)
{
    const SurfaceTable::Jet jet = s.jet(uv);
    const glm::dvec3 n = glm::cross(jet.u, jet.v);
    const double length = glm::length(n);
    return length > 0 ? glm::dot(n, view.toward_eye(jet.value)) / length : 0;
}

// Returns the places of rays through a cell along an axis, with the rim for a cell at the rim.
std::vector<double> along(int cell, int cells, int rays, double shift)
{
    std::vector<double> out;
    if (cell == 0 && rays > 1) out.push_back(0);
    for (int k = 0; k < rays; ++k) out.push_back((cell + (k + shift) / rays) / cells);
    if (cell + 1 == cells && rays > 1) out.push_back(1);
    return out;
}

} // namespace

std::vector<char> steep_corners(const SurfaceTable& s, const StripCut& cut,
                                const std::vector<char>& changed, const View& view, double limit)
{
    std::vector<char> out(changed.size(), 0), steep_here(changed.size(), 0);
    const glm::ivec2 last = cut.quads();
    const int q = cut.quads_a_cell, step = q / 2;
    const auto rows = static_cast<std::size_t>(last.x / step) + 1;
    parallel_blocks(rows, 8, [&](std::size_t begin, std::size_t end) {
        for (int i = static_cast<int>(begin) * step; i < static_cast<int>(end) * step; i += step)
            for (int j = 0; j <= last.y; j += step) {
                const std::size_t k = cut.corner(i, j);
                if (changed[k])
                    steep_here[k] = facing(s, glm::dvec2(i, j) / glm::dvec2(last), view) <= limit;
            }
    });
    for (int i = 0; i <= last.x; i += step)
        for (int j = 0; j <= last.y; j += step) {
            if (!steep_here[cut.corner(i, j)]) continue;
            for (int a = std::max(0, (i / q - 1) * q); a <= std::min(last.x, (i / q + 2) * q); ++a)
                for (int b = std::max(0, (j / q - 1) * q); b <= std::min(last.y, (j / q + 2) * q);
                     ++b)
                    out[cut.corner(a, b)] = 1;
        }
    return out;
}

SeenBehind seen_behind(const SurfaceTable& s, const StripCut& cut, const std::vector<char>& marked,
                       const RayLook& look, const View& view, const RayScene& scene,
                       const JudgeOptions& options)
{
    const double shift = std::fmod(0.37 + 0.19 * look.turn, 1);
    const std::vector<char> edge_on = look.where_steep > 1
                                          ? steep_corners(s, cut, marked, view, steep)
                                          : std::vector<char>(marked.size(), 0);
    // Cells are grouped in blocks of about equal numbers of rays.
    std::vector<Cell> cells;
    std::vector<std::size_t> blocks{0};
    std::size_t rays = 0;
    for (int i = 0; i < cut.cells.x; ++i)
        for (int j = 0; j < cut.cells.y; ++j) {
            const std::size_t middle = cut.middle_of_cell(i, j);
            if (!marked[middle]) continue;
            const bool rim = i == 0 || j == 0 || i + 1 == cut.cells.x || j + 1 == cut.cells.y;
            cells.push_back({{i, j}, edge_on[middle] || rim ? look.where_steep : 1});
            rays += static_cast<std::size_t>(cells.back().rays * cells.back().rays);
            if (rays < rays_a_block) continue;
            blocks.push_back(cells.size());
            rays = 0;
        }
    if (blocks.back() < cells.size()) blocks.push_back(cells.size());

    std::vector<SeenBehind> seen(blocks.size() - 1);
    parallel_blocks(seen.size(), 1, [&](std::size_t block, std::size_t) {
        std::vector<glm::dvec2> uv;
        std::vector<double> until;
        std::vector<Ray> through;
        for (std::size_t c = blocks[block]; c < blocks[block + 1]; ++c) {
            const Cell& cell = cells[c];
            const std::vector<double> u = along(cell.at.x, cut.cells.x, cell.rays, shift);
            const std::vector<double> v = along(cell.at.y, cut.cells.y, cell.rays, 1 - shift);
            for (const double a : u)
                for (const double b : v) uv.emplace_back(a, b);
            for (const glm::dvec3& p : s.grid(u, v)) {
                through.push_back(view.ray_to(p));
                until.push_back(glm::dot(p - through.back().origin, through.back().direction) +
                                options.clearance);
            }
        }
        const auto hits = look.beyond ? scene.hits(through, look.skip_back_faces)
                                      : scene.hits(through, look.skip_back_faces, until);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            if (!hits[k]) continue;
            const double behind = until[k] - hits[k]->distance;
            Judgement& found = seen[block].found;
            found.worst = std::max(found.worst, behind);
            seen[block].largest_gap = std::max(seen[block].largest_gap, options.clearance - behind);
            if (behind > options.let_be) found.behind.push_back({hits[k]->p_world, uv[k]});
        }
    });
    SeenBehind out;
    for (const SeenBehind& part : seen) {
        out.found.add(part.found);
        out.largest_gap = std::max(out.largest_gap, part.largest_gap);
    }
    return out;
}

} // namespace trivar
