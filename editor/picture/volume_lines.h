// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/evaluated.h"
#include "core/silhouette/line_ids.h"
#include "gpu/curve.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace trivar {

// VolumeLines draws the silhouettes of the levels that objects of volume data show, seen from a
// camera. It keeps those of the last few views. Where a level shows a share of its lines, those
// that were shown in the view before stay rather than others, so that they do not come and go while
// the view turns.
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
    // What is remembered of the lines of an object's levels from view to view, by layer.
    struct Memory {
        std::map<std::string, LineIds> ids;
        std::map<std::string, std::vector<std::uint64_t>> kept;
    };
    std::vector<gpu::Curve> lines_of(const EvaluatedObject& object, const glm::dmat4& to_world,
                                     const Camera& camera, float wider);
    std::map<int, Memory> memories_; // by object
};

} // namespace trivar
