// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/step.h"

namespace trivar {

// ShadingStep gives the meshes of a shape normals by their faces. Stage: shade.
class ShadingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Recent<std::pair<Ref<Mesh>, float>, Ref<Mesh>> shaded_; // whatever pose they are in
    Recent<std::pair<Ref<Stage>, float>, Ref<Stage>> known_;
};

} // namespace trivar
