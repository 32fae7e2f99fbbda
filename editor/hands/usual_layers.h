// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/incising.h"

#include <cmath>

namespace trivar {

// A body as it usually is: skin, fat and flesh, down to a depth in metres on the model.
inline std::vector<IncisionLayer> usual_layers(double deepest)
{
    const auto share = [&](double s) { return std::round(s * deepest * 1e5) / 1e5; };
    return {{"Skin", share(0.12), {{0.62f, 0.3f, 0.24f, 1}, 0, 0.5f}},
            {"Fat", share(0.4), {{0.88f, 0.68f, 0.42f, 1}, 0, 0.45f}},
            {"Flesh", deepest, {{0.42f, 0.05f, 0.04f, 1}, 0, 0.35f}}};
}

} // namespace trivar
