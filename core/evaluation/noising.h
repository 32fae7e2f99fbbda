// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/step.h"

namespace trivar {

// Shifts the vertices of what is shown, each by a random vector of its number.
class Noising : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Recent<std::pair<Ref<Stage>, Noise>, Ref<Stage>> known_;
};

} // namespace trivar
