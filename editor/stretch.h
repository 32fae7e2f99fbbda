// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/part.h"

#include <map>

namespace trivar {

// How much the volume of what was placed changed at each vertex beside what is usual in that mesh,
// the median; worked out once for each part and kept as long as that.
class Stretches {
public:
    // Null for a part that was not deformed.
    Ref<std::vector<float>> of(const Part& part);

private:
    struct Known {
        std::weak_ptr<const Bent> alive;
        Ref<std::vector<float>> values;
    };
    std::map<const Bent*, Known> known_;
};

} // namespace trivar
