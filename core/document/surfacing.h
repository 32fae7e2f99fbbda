// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar {

struct Surfacing { // one material over the whole object, in place of the object's own
    glm::vec4 base_color{0.8f, 0.8f, 0.8f, 1};
    float metallic = 0, roughness = 0.6f;
    Filling filling = Filling::none;
    float glow = 0; // light that it gives off by itself: its colour times this
    bool operator==(const Surfacing&) const = default;
};

} // namespace trivar
