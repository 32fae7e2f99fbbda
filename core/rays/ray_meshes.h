// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/rays/ray_scene.h"

#include <map>

namespace trivar {

// RayMeshes keeps the bounding-volume hierarchies of meshes on which strokes may fall; each is
// built once.
class RayMeshes {
public:
    Ref<RayMesh> operator()(const Ref<Mesh>& mesh, Timings& timings); // stage: rays
    void forget_unused(); // those that no RayScene uses any more

private:
    std::map<Ref<Mesh>, Ref<RayMesh>> known_;
};

} // namespace trivar
