// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/along_obstacles.h"

#include <cmath>

namespace trivar {

SplitFrame along_obstacles(const std::vector<SplitObstacle>& obstacles, SplitFrame frame)
{
    constexpr double long_for_a_bar = 2;  // times as long as wide
    constexpr double least_upright = 0.5; // cosine of the angle from w to the bar
    double count = 0;
    glm::dvec2 origin(0); // the first: far from 0 squares would lose what is between the points
    glm::dvec2 sum(0);
    glm::dmat2 squares(0);
    for (const SplitObstacle& obstacle : obstacles)
        for (const RayScene::Entry& body : obstacle.bodies)
            for (const glm::vec3& p : body.mesh->mesh().positions) {
                const glm::dvec3 uvw = frame.uvw(body.to_world * glm::dvec4(glm::dvec3(p), 1));
                if (count == 0) origin = {uvw.y, uvw.z};
                const glm::dvec2 vw = glm::dvec2(uvw.y, uvw.z) - origin;
                count += 1;
                sum += vw;
                squares += glm::outerProduct(vw, vw);
            }
    if (count == 0) return frame;
    const glm::dmat2 moments = squares / count - glm::outerProduct(sum / count, sum / count);
    const double vv = moments[0][0], ww = moments[1][1], vw = moments[0][1];
    const double middle = (vv + ww) / 2, half = std::hypot((ww - vv) / 2, vw);
    const double lean = std::atan2(2 * vw, ww - vv) / 2; // from w toward v
    if (!(middle + half > long_for_a_bar * long_for_a_bar * (middle - half)) ||
        std::cos(lean) < least_upright)
        return frame;
    frame.axes[2] = std::cos(lean) * frame.axes[2] + std::sin(lean) * frame.axes[1];
    frame.axes[1] = glm::cross(frame.axes[2], frame.axes[0]);
    return frame;
}

} // namespace trivar
