// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_rays.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double steep = 0.3; // cosine to the ray below which a cell gets more rays

// The cosine between the surface and the line of sight.
double facing(const SurfaceTable& s, glm::dvec2 uv, const View& view)
{
    const SurfaceTable::Jet jet = s.jet(uv);
    const glm::dvec3 n = glm::cross(jet.u, jet.v);
    const double length = glm::length(n);
    return length > 0 ? glm::dot(n, view.toward_eye(jet.value)) / length : 0;
}

} // namespace

std::vector<char> steep_corners(const SurfaceTable& s, const StripCut& cut,
                                const std::vector<char>& changed, const View& view, double limit)
{
    std::vector<char> out(changed.size(), 0);
    const glm::ivec2 last = cut.quads();
    const int q = cut.quads_a_cell;
    for (int i = 0; i <= last.x; i += q / 2)
        for (int j = 0; j <= last.y; j += q / 2) {
            if (!changed[cut.corner(i, j)]) continue;
            if (facing(s, glm::dvec2(i, j) / glm::dvec2(last), view) > limit) continue;
            for (int a = std::max(0, (i / q - 1) * q); a <= std::min(last.x, (i / q + 2) * q); ++a)
                for (int b = std::max(0, (j / q - 1) * q); b <= std::min(last.y, (j / q + 2) * q);
                     ++b)
                    out[cut.corner(a, b)] = 1;
        }
    return out;
}

std::vector<SceneSample> seen_behind(const SurfaceTable& s, const StripCut& cut,
                                     const std::vector<char>& changed, int many, int look,
                                     const View& view, const RayScene& scene, bool skip_back_faces)
{
    const double shift = std::fmod(0.37 + 0.19 * look, 1);
    const std::vector<char> edge_on = steep_corners(s, cut, changed, view, steep);
    std::vector<glm::dvec2> uv;
    for (int i = 0; i < cut.cells.x; ++i)
        for (int j = 0; j < cut.cells.y; ++j) {
            if (!changed[cut.middle_of_cell(i, j)]) continue;
            const int rays = edge_on[cut.middle_of_cell(i, j)] ? many : 1;
            for (int a = 0; a < rays; ++a)
                for (int b = 0; b < rays; ++b)
                    uv.push_back(
                        (glm::dvec2(i, j) + (glm::dvec2(a, b) + glm::dvec2(shift, 1 - shift)) /
                                                static_cast<double>(rays)) /
                        s.cells());
        }
    std::vector<Ray> rays;
    rays.reserve(uv.size());
    for (const glm::dvec2& at : uv) rays.push_back(view.ray(view.project(s.jet(at).value).p_px));
    const auto hits = scene.hits(rays, skip_back_faces);
    std::vector<SceneSample> out;
    for (std::size_t k = 0; k < uv.size(); ++k)
        if (hits[k]) out.push_back({hits[k]->p_world, uv[k]});
    return out;
}

} // namespace trivar
