// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/placement/shaper.h"
#include "core/stages/bending.h"
#include "core/stages/bending_volume.h"
#include "core/stages/step.h"

namespace trivar {

// LatticeStep gives a lattice its volume, and renews it when box, steps or place change. The
// volume of a stroke on which the lattice lies is put aside, to bend the box. Stage: shape.
class LatticeStep : public Step {
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

// BendingStep deforms the parts of one object by the volumes round it, one after the other, each
// starting from the result of the one before. A part that already lies in a volume is deformed at
// once, so that it can be deformed further.
class BendingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    std::vector<Part> bent(std::vector<Part> parts, const std::vector<BendingVolume>& volumes);
    Ref<Lattice> reaching_round(const std::vector<Part>& parts, const BendingVolume& volume);
    void tell_what_is_outside(const std::vector<BendingVolume>& volumes,
                              std::vector<std::string>& notices) const;

    std::vector<Bending> bendings_;
    std::vector<SimplexBending> simplex_bendings_;
    Recent<std::pair<Ref<Stage>, std::vector<BendingVolume>>, Ref<Stage>> known_;
    struct LongerVolume {
        Ref<Lattice> of;
        Lattice longer;
        bool operator==(const LongerVolume&) const = default;
    };
    Recent<LongerVolume, Ref<Lattice>> longer_;
};

} // namespace trivar
