// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/step.h"

namespace trivar {

// Splits the triangles of what lies in a volume, for the frame that it lies there in. Stage:
// refine.
class RefiningStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Recent<std::pair<Ref<Stage>, Refining>, Ref<Stage>> known_;
};

// Whether a volume bends it: that of its stroke, or a lattice.
bool lies_in_a_volume(const Stage& stage);

// Parts that lie in one volume with their triangles split, in that volume. Throws Rejected as
// refine() does.
struct SplitParts {
    Ref<RefinementResult> refined;
    std::vector<Part> parts;
};
SplitParts split(const std::vector<Part>& parts, const RefineOptions& options,
                 const Progress& progress = {});

// What is to be said of it: what is not certified, and why. Empty: all of it is.
std::string notice_of(const RefinementResult& refined, const Refining& refining);

} // namespace trivar
