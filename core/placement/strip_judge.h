// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/judgement.h"
#include "core/placement/near_scene.h"

namespace trivar {

// A ScenePoint is a measured point of a triangle of the scene: a vertex or another one.
struct ScenePoint {
    glm::dvec3 p_world{0};
    glm::dvec2 p_px{0};
    double depth_world = 0;
    // distance to the nearest layer of the strip, where the strip covers the point
    double gap = 1e300;
    glm::dvec2 uv{0}; // on that layer
    bool covered = false;
};

// A StripJudge measures the whole of the scene under the strip against the surface. A triangle lies
// behind the surface when the surface is before its corners by more than it can sag between them;
// otherwise the triangle is halved across its longest edge and both halves are measured. Where the
// rim of the strip cuts a triangle, the cuts are corners, too. So every ridge is found however
// thin, a plane is sampled as finely as the surface over it bends, and triangles hidden far behind
// cost next to nothing. Hidden points do no harm, for a surface in front of the nearest surface is
// in front of them. Surface, view and scene must outlive the judge.
class StripJudge {
public:
    StripJudge(const SurfaceTable& surface, const View& view, const NearScene& scene,
               const JudgeOptions& options);

    // Measures the parts that changed since the last call, according to the index. Parallel.
    Judgement judge(const StripIndex& strip);

private:
    const SurfaceTable& surface_;
    const View& view_;
    const NearScene& scene_;
    JudgeOptions options_;
    std::vector<ScenePoint> corners_; // one per vertex of the scene
};

} // namespace trivar
