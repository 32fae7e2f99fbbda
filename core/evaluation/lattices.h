// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/bending.h"
#include "core/evaluation/step.h"
#include "core/placement/shaper.h"

namespace trivar {

// Gives a lattice its volume, while its box, its steps or its place change. Stage: shape.
class LatticeVolume : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    Ref<ShapedVolume> in_world(const LatticeShape& shape, const StepInput& input);

    LatticeShape shape_;
    Ref<Placement> at_rest_;
    std::vector<Ref<VolumeEdit>> shaping_;
    Shaper shaper_;
    Ref<ShapedVolume> shaped_; // about the origin
    glm::dmat4 to_world_{1};
    Ref<ShapedVolume> mapped_;
    Recent<std::pair<Ref<Stage>, Ref<ShapedVolume>>, Ref<Stage>> known_;
};

// Bends the parts of one object by the lattices that it stands in, one after the other, each of
// what the one before left. What lies in a volume already is deformed at once to be bent further.
class InLattices : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    std::vector<Part> bent(std::vector<Part> parts, const std::vector<Ref<ShapedVolume>>& lattices);

    std::vector<Bending> bendings_;
    Recent<std::pair<Ref<Stage>, std::vector<Ref<ShapedVolume>>>, Ref<Stage>> known_;
};

} // namespace trivar
