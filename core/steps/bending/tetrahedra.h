// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/step.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

#include <tuple>

namespace trivar {

// A TetrahedraStep gives a volume of tetrahedra its effects. A volume that cannot be, for example
// because its clouds cross, bends nothing, and a notice says why. Stage: shape.
class TetrahedraStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    TetrahedraShaper shaper_;
    Recent<TetrahedraShape, Ref<ShapedTetrahedra>> shaped_;
    struct Input {
        Ref<Stage> before;
        Ref<ShapedTetrahedra> shaped;
        glm::dmat4 to_world;
        bool operator==(const Input&) const = default;
    };
    Recent<Input, Ref<Stage>> known_;
    using FunctionKey = std::tuple<Ref<SimplexBasis<3>>, int, double>;
    Recent<FunctionKey, Ref<Mesh>> surfaces_{most_shown_functions};

    Ref<Mesh> surface_of(const TetrahedraFunction& function, const Ref<SimplexBasis<3>>& basis);
};

} // namespace trivar
