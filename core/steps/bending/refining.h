// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/refinement/refine.h"
#include "core/stages/step.h"

namespace trivar {

// The end of the notice for a refinement that needs more triangles than it may have.
inline constexpr const char* spent_budget_words = "that it may have are spent";

// RefiningStep splits the triangles of parts in volumes, for the frame that is evaluated. Stage:
// refine.
class RefiningStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Recent<std::pair<Ref<Stage>, Refining>, Ref<Stage>> known_;
};

// Whether a volume deforms the object: that of its stroke, or a lattice.
bool lies_in_a_volume(const Stage& stage);

// SplitParts holds parts in the same volumes after their triangles were split. split() throws
// Rejected as refine() does.
struct SplitParts {
    Ref<RefinementResult> refined;
    std::vector<Part> parts;
};
SplitParts split(const std::vector<Part>& parts, const RefineOptions& options,
                 const Progress& progress = {});

// Bounds how far the triangles of one part in volumes are off, as they are. Throws Rejected as
// refine() does.
RefinementResult bounded(const Part& part, const RefineOptions& options);

// Returns a sentence on the parts that are not certified, and why; empty: all are.
std::string notice_of(const RefinementResult& refined, const Refining& refining);

} // namespace trivar
