// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rays/ray_meshes.h"

namespace trivar {

Ref<RayMesh> RayMeshes::operator()(const Ref<Mesh>& mesh, Timings& timings)
{
    Ref<RayMesh>& known = known_[mesh];
    if (!known)
        known = timed(timings, "rays", [&] { return std::make_shared<const RayMesh>(mesh); });
    return known;
}

void RayMeshes::forget_unused()
{
    std::erase_if(known_, [](const auto& known) { return known.second.use_count() == 1; });
}

} // namespace trivar
