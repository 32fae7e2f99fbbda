// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/placement/ray_scene.h"

#include <map>

namespace trivar {

// The bounding-volume hierarchies of meshes that strokes may fall on, each built once.
class RayMeshes {
public:
    Ref<RayMesh> operator()(const Ref<Mesh>& mesh, Timings& timings); // stage: rays
    void forget_unused();                                             // that no scene for rays has

private:
    std::map<Ref<Mesh>, Ref<RayMesh>> known_;
};

} // namespace trivar
