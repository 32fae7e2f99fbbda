// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/progress.h"
#include "core/base/recent.h"
#include "core/tetrahedra/fold_guard.h"
#include "core/tetrahedra/tetrahedra_shape.h"

#include <string>

namespace trivar {

// A TetrahedraOutcome is the result of one edit.
struct TetrahedraOutcome {
    double share = 1; // of what was asked; less where the guard held it
    std::string notice = {};
};
struct ShapedTetrahedra {
    Ref<SimplexVolume> volume;
    std::vector<TetrahedraOutcome> outcomes; // one per edit
};

// A TetrahedraShaper makes the volume of a shape. It keeps the last domains, so that an edit costs
// its control points alone.
class TetrahedraShaper {
public:
    // Throws Rejected for a domain that cannot be: see check() of core/simplex/simplex_domain.h.
    ShapedTetrahedra operator()(const TetrahedraShape& shape, const Progress& progress = {});

private:
    struct Domain {
        std::vector<Ref<SimplexBasis<3>>> layers;
        Lazy<FoldGuard> guard;
    };
    // The key is the shape with only the edits that change the domain.
    Recent<TetrahedraShape, Ref<Domain>> domains_;
};

} // namespace trivar
