// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/single_precision.h"

namespace trivar {

glm::vec3 in_single_precision(const glm::dvec3& v)
{
    return glm::vec3(v);
}

} // namespace trivar
