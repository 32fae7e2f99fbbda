// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/evaluate.h"

#include <map>

namespace trivar {

// How much the volume of what was placed changed at each vertex beside what is usual in that mesh,
// the median; worked out once for each deformed mesh and kept as long as that.
class Stretches {
public:
    // Null for a part that was not deformed.
    Ref<std::vector<float>> of(const Part& part, const EvaluatedObject& object);

private:
    struct Known {
        std::weak_ptr<const Mesh> alive;
        Ref<std::vector<float>> values;
    };
    std::map<const Mesh*, Known> known_;
};

} // namespace trivar
