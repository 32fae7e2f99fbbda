// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/check_view.h"

#include "core/base/rejected.h"

namespace trivar {

void check_view(const Camera& camera)
{
    const glm::dvec3 forward = camera.target - camera.eye;
    if (!(glm::length(forward) > 1e-9))
        throw Rejected("the camera's \"target\" must not lie at its \"eye\"");
    if (!(glm::length(glm::cross(glm::normalize(forward), camera.up)) > 1e-9))
        throw Rejected("the camera's \"up\" must not point along its view");
}

} // namespace trivar
