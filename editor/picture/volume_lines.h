// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/evaluated.h"
#include "gpu/curve.h"

#include <tuple>
#include <vector>

namespace trivar {

// VolumeLines draws the silhouettes of the levels that objects of volume data show, seen from a
// camera. It keeps those of the last few views.
class VolumeLines {
public:
    // The curves of an object whose model `to_world` puts into the world; `wider` is the width of a
    // line in pixels per pixel of a picture of the usual height. Empty for what is no volume data.
    // 0.25 us per point of the curves, and 4 ns per triangle that they may cross.
    const std::vector<gpu::Curve>& operator()(const EvaluatedObject& object,
                                              const glm::dmat4& to_world, const Camera& camera,
                                              float wider);

private:
    using Key = std::tuple<Ref<ShownVolume>, glm::dmat4, Camera, int>; // with the object
    Recent<Key, std::vector<gpu::Curve>> known_{16};
};

} // namespace trivar
