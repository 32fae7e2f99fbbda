// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/judgement.h"
#include "core/placement/near_scene.h"

namespace trivar {

// A vertex or another point of a triangle of the scene, measured.
struct ScenePoint {
    glm::dvec3 p_world{0};
    glm::dvec2 p_px{0};
    double depth_world = 0;
    double gap = 1e300; // to the nearest layer of the strip, where it is covered
    glm::dvec2 uv{0};   // on that layer
    bool covered = false;
};

// Measures the whole of the scene under the strip against the surface. A triangle is in front of
// nothing when the surface is before its corners by more than it can sag between them; otherwise
// the triangle is halved across its longest edge and looked at again. Where the rim of the strip
// cuts it the cuts are corners, too. So a ridge is found however thin, a plane is sampled as
// finely as the surface over it bends, and what lies hidden far behind costs next to nothing.
// Hidden points do no harm, for what stays in front of the nearest surface stays in front of them.
// Surface, view and scene must outlive it.
class StripJudge {
public:
    StripJudge(const SurfaceTable& surface, const View& view, const NearScene& scene,
               const JudgeOptions& options);

    // Looks at what has changed since the last time, according to the index. Parallel.
    Judgement judge(const StripIndex& strip);

private:
    const SurfaceTable& surface_;
    const View& view_;
    const NearScene& scene_;
    JudgeOptions options_;
    std::vector<ScenePoint> corners_; // of the scene's vertices
};

} // namespace trivar
