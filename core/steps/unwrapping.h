// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/step.h"
#include "core/unwrap/unwrap.h"

namespace trivar {

// UnwrappingStep gives the meshes of a shape texture coordinates made here, all in one square.
// Stage: unwrap.
class UnwrappingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    // The meshes at rest, each with the size of its node
    using Meshes = std::vector<std::pair<Ref<Mesh>, double>>;
    struct Unwraps {
        std::map<Ref<Mesh>, Ref<Mesh>> to; // empty: they cannot be
        UnwrapFacts facts;
        std::string trouble;
    };
    Recent<std::pair<Meshes, Unwrapping>, Ref<Unwraps>> unwraps_; // whatever pose they are in
    // The last bool of the key says whether it also has a surface of its own.
    Recent<std::tuple<Ref<Stage>, Unwrapping, bool>, Ref<Stage>> known_;
};

} // namespace trivar
