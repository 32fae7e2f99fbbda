// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/gap.h"

#include <algorithm>

namespace trivar {

struct JudgeOptions {
    double clearance = 0;   // metres to keep in front of the scene
    double let_be = 1e-4;   // metres behind that are as good as none
    double hopeless = 1e-3; // metres behind from which finer looks are no use: it is lifted first
};

struct Judgement {
    std::vector<SceneSample> behind; // by more than let_be
    double worst = 0;                // metres behind, of all points looked at

    void add(const Judgement& other)
    {
        behind.insert(behind.end(), other.behind.begin(), other.behind.end());
        worst = std::max(worst, other.worst);
    }
};

} // namespace trivar
