// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/gap.h"

#include <algorithm>

namespace trivar {

struct JudgeOptions {
    double clearance = 0; // metres that the surface must keep in front of the scene
    double let_be = 1e-4; // metres behind the scene that are ignored
    // metres behind the scene from which finer looks are useless: the surface is lifted first
    double hopeless = 1e-3;
};

struct Judgement {
    std::vector<SceneSample> behind; // samples that are behind by more than let_be
    double worst = 0;                // largest distance behind, in metres, of all points looked at

    void add(const Judgement& other)
    {
        behind.insert(behind.end(), other.behind.begin(), other.behind.end());
        worst = std::max(worst, other.worst);
    }
};

} // namespace trivar
