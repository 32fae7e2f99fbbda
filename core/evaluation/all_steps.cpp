// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/bending/lattices.h"
#include "core/steps/bending/refining.h"
#include "core/steps/bending/tetrahedra.h"
#include "core/steps/cutting.h"
#include "core/steps/incising.h"
#include "core/steps/lacking.h"
#include "core/steps/laying/following.h"
#include "core/steps/laying/laying.h"
#include "core/steps/moving/moving.h"
#include "core/steps/shading_step.h"
#include "core/steps/simplifying.h"
#include "core/steps/splitting.h"
#include "core/steps/tiles/tiling.h"
#include "core/steps/unwrapping.h"

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
    const auto stroke_motions = std::make_shared<StrokeMotions>();
    steps.push_back(std::make_unique<LayingStep>(stroke_motions));
    steps.push_back(std::make_unique<MovingStep>());
    steps.push_back(std::make_unique<TilingStep>());
    steps.push_back(std::make_unique<FollowingStep>(stroke_motions));
    steps.push_back(std::make_unique<LatticeStep>());
    steps.push_back(std::make_unique<TetrahedraStep>());
    steps.push_back(std::make_unique<WithinReach>());
    steps.push_back(std::make_unique<BendingStep>());
    steps.push_back(std::make_unique<RefiningStep>());
    steps.push_back(std::make_unique<CuttingStep>(false));
    steps.push_back(std::make_unique<SplittingStep>());
    steps.push_back(std::make_unique<CuttingStep>(true));
    return steps;
}

} // namespace trivar
