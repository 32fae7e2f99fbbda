// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/pose.h"
#include "gpu/ffd/device_deformer.h"

#include <map>

namespace trivar::gpu {

// `kinds` of a target's differences: 1 positions, 2 normals too, 3 tangents too; 0: no targets.
ProgramName pose_program(bool skinned, int kinds, bool normals, bool tangents);

// A DevicePoser poses meshes on the device, as trivar::posed() does, up to single precision.
// Influences and morph targets are uploaded once per mesh (32 bytes per vertex, and 12 to 36 per
// target), a pose takes 64 bytes per joint and 4 per target.
class DevicePoser {
public:
    // The programs belong to the deformer that runs afterwards, and must outlive the poser.
    explicit DevicePoser(Programs& programs, const DeviceLimits& limits = device_limits())
        : limits_(limits),
          programs_(programs)
    {
    }

    // `from` holds the vertices of posed.rest. Any pass and the deformer may read `to`; nothing is
    // read back. Throws Rejected where the device has no room.
    void pose(const VertexSource& from, DeviceVertices& to, const PosedMesh& posed);
    void drop_dead(); // frees rigs of meshes that nobody else holds

private:
    struct Rig {
        std::weak_ptr<const Mesh> alive;
        Buffer buffer;
        int kinds = 0; // of a target's differences: 1 positions, 2 normals too, 3 tangents too
        std::vector<Box> targets;
    };
    const Rig& rig(const Ref<Mesh>& mesh);
    DeviceLimits limits_;
    std::map<const Mesh*, Rig> rigs_;
    Programs& programs_;
    Buffer pose_;
};

} // namespace trivar::gpu
