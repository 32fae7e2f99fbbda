// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/obstacle_columns.h"

#include "core/base/rejected.h"

namespace trivar {

ObstacleColumns::ObstacleColumns(const std::vector<RayScene::Entry>& bodies,
                                 const SplitFrame& frame)
    : scene_(bodies),
      frame_(frame)
{
    for (const RayScene::Entry& body : bodies) {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (const glm::uvec3& t : body.mesh->triangles()) triangles_.push_back(t + first);
        for (const glm::vec3& p : body.mesh->mesh().positions) {
            const glm::dvec3 uvw =
                frame.uvw(glm::dvec3(body.to_world * glm::dvec4(glm::dvec3(p), 1)));
            vertices_.push_back(uvw);
            box_.add(uvw);
        }
    }
    const glm::dvec3 size = box_.size();
    if (!(size.x > 0 && size.y > 0 && size.z > 0))
        throw Rejected(
            "is flat or empty as seen along the split; turn it, or the directions of the split, or "
            "choose an obstacle with a thickness");
}

std::vector<std::optional<glm::dvec2>> ObstacleColumns::at(std::span<const glm::dvec2> vw) const
{
    const double far = box_.size().x;
    std::vector<Ray> rays;
    rays.reserve(2 * vw.size());
    for (const glm::dvec2& p : vw) {
        rays.push_back({frame_.world({box_.lo.x - far, p.x, p.y}), frame_.axes[0]});
        rays.push_back({frame_.world({box_.hi.x + far, p.x, p.y}), -frame_.axes[0]});
    }
    const std::vector<std::optional<Hit>> hits = scene_.hits(rays);
    std::vector<std::optional<glm::dvec2>> out(vw.size());
    for (std::size_t i = 0; i < vw.size(); ++i) {
        const std::optional<Hit>&from = hits[2 * i], &to = hits[2 * i + 1];
        if (!from || !to) continue;
        const double lo = box_.lo.x - far + from->distance, hi = box_.hi.x + far - to->distance;
        if (lo <= hi) out[i] = glm::dvec2(lo, hi);
    }
    return out;
}

} // namespace trivar
