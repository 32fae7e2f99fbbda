// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/level/level_mesh.h"
#include "core/silhouette/silhouettes.h"
#include "gpu/buffer.h"
#include "gpu/program.h"

namespace trivar::gpu {

// DeviceSilhouettes finds on the graphics card which triangles of a level a silhouette crosses:
// what SilhouetteFinder does with nearly all triangles. The processor makes curves of the few that
// are found, so that both give the same curves, bit by bit. Needs OpenGL 4.3.
class DeviceSilhouettes {
public:
    static std::vector<ProgramName> programs();
    // Whether shaders of this device see all of a level.
    static bool fits(const LevelMesh& level);

    // Uploads a level, unless it is the one that is there: 16 bytes per vertex, 12 per triangle.
    void take(const Ref<LevelMesh>& level);
    // Numbers of the triangles of the level in which the sign of <V, n> changes, ascending. One
    // dispatch and one read: 4 bytes per triangle found come back. Waits for the device.
    const std::vector<std::uint32_t>& crossed(Programs& programs, const ViewPoint& view);

private:
    void make_room(std::size_t triangles);
    Ref<LevelMesh> level_;
    Buffer normals_, corners_, runs_, found_;
    std::size_t run_count_ = 0, room_ = 0;
    std::size_t last_count_ = 0;
    std::vector<std::uint32_t> triangles_;
};

} // namespace trivar::gpu
