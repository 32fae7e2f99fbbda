// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/silhouette/scenes.h"

#include <random>

namespace trivar::testing {

std::vector<ViewPoint> some_views(const glm::ivec3& size, int count)
{
    std::minstd_rand random(7);
    std::normal_distribution<double> normal;
    std::vector<ViewPoint> out;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 v =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        out.push_back(
            i % 2 ? ViewPoint{glm::dvec4(v, 0)}
                  : ViewPoint{glm::dvec4(
                        glm::dvec3(size) / 2.0 + 1.5 * v * static_cast<double>(size.x), 1)});
    }
    return out;
}

glm::dmat4 image_of(const glm::dvec3& sight)
{
    const glm::dvec3 v = glm::normalize(sight), right = glm::normalize(glm::cross(v, {0, 0, 1})),
                     down = glm::cross(v, right);
    glm::dmat4 out(1);
    for (int k = 0; k < 3; ++k) {
        out[k] = {4 * right[k], 4 * down[k], 0.001 * v[k], 0};
        out[3][k] = k < 2 ? 500 : 0.5;
    }
    return out;
}

} // namespace trivar::testing
