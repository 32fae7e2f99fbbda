// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/step.h"

namespace trivar {

// SimplifyingStep reduces the triangles of a shape in its rest pose and with its clips. Stage:
// simplify.
class SimplifyingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Recent<std::pair<Ref<Stage>, Simplifying>, Ref<Stage>> known_;
};

} // namespace trivar
