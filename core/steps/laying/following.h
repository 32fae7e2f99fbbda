// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/placement/shaper.h"
#include "core/steps/laying/stroke_motions.h"

#include <memory>

namespace trivar {

// Moves an object on an attached stroke to the present place of its hosts, volume and all: by one
// matrix, so nothing is laid again and no vertex is worked out before somebody asks for it.
class FollowingStep : public Step {
public:
    explicit FollowingStep(std::shared_ptr<StrokeMotions> stroke_motions)
        : stroke_motions_(std::move(stroke_motions))
    {
    }
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    std::shared_ptr<StrokeMotions> stroke_motions_;
    Recent<std::pair<Ref<Stage>, Ref<StrokeMotion>>, Ref<Stage>> known_;
};

// A placement where a matrix takes it that turns, scales evenly and shifts; lengths of its report
// go with the scale.
Placement carried(Placement placement, const glm::dmat4& to_world);
Ref<ShapedVolume> carried(const ShapedVolume& shaped, const glm::dmat4& to_world); // likewise

} // namespace trivar
