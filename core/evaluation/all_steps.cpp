// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/cutting.h"
#include "core/evaluation/incising.h"
#include "core/evaluation/lacking.h"
#include "core/evaluation/lattices.h"
#include "core/evaluation/laying.h"
#include "core/evaluation/moving.h"
#include "core/evaluation/refining.h"
#include "core/evaluation/riding.h"
#include "core/evaluation/shading_step.h"
#include "core/evaluation/simplifying.h"
#include "core/evaluation/splitting.h"
#include "core/evaluation/tetrahedra.h"
#include "core/evaluation/tiling.h"
#include "core/evaluation/unwrapping.h"

namespace trivar {
namespace {

class WithinReach : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput&) override
    {
        return known_(before, [&] {
            if (is_within_reach(*before)) return before;
            Stage stage = *before;
            leave_out_what_is_out_of_reach(stage);
            return make_ref(std::move(stage));
        });
    }

private:
    Recent<Ref<Stage>, Ref<Stage>> known_;
};

} // namespace

std::vector<std::unique_ptr<Step>> all_steps()
{
    std::vector<std::unique_ptr<Step>> steps;
    steps.push_back(std::make_unique<SimplifyingStep>());
    steps.push_back(std::make_unique<UnwrappingStep>());
    steps.push_back(std::make_unique<ShadingStep>());
    steps.push_back(std::make_unique<IncisingStep>());
    const auto carriages = std::make_shared<Carriages>();
    steps.push_back(std::make_unique<Laying>(carriages));
    steps.push_back(std::make_unique<Moving>());
    steps.push_back(std::make_unique<TilingStep>());
    steps.push_back(std::make_unique<Riding>(carriages));
    steps.push_back(std::make_unique<LatticeVolume>());
    steps.push_back(std::make_unique<TetrahedraStep>());
    steps.push_back(std::make_unique<WithinReach>());
    steps.push_back(std::make_unique<InLattices>());
    steps.push_back(std::make_unique<RefiningStep>());
    steps.push_back(std::make_unique<CuttingStep>(false));
    steps.push_back(std::make_unique<SplittingStep>());
    steps.push_back(std::make_unique<CuttingStep>(true));
    return steps;
}

} // namespace trivar
