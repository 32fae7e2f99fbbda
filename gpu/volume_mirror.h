// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/cast_volume.h"
#include "gpu/texture.h"
#include "gpu/texture3d.h"

#include <map>
#include <memory>
#include <string>

namespace trivar::gpu {

// MirroredSamples are numbers on a grid: x a + y where the texture has a.
struct MirroredSamples {
    Texture3D texels;
    glm::vec2 share{1, 0};
};

// A MirroredVolume is volume data on the GPU with a transfer function.
struct MirroredVolume {
    const MirroredSamples* samples = nullptr;
    const MirroredSamples* coefficients = nullptr; // with the border of one; null: not wanted
    Texture2D transfer;                            // a row: TransferTable::before
    Texture3D empty;                               // EmptyBricks::reach
    Texture3D open;                                // OpenBricks::share
    // Each maps a value v of its texture to the share v x + y of the range of the data.
    glm::vec2 sample_share{1, 0}, coefficient_share{1, 0};
    FieldOrder order = FieldOrder::linear;
    glm::vec3 last{0}; // the greatest coordinates
};

// A VolumeMirror uploads volume data by Ref identity, as Mirror uploads meshes. On the GPU samples
// of 8 bits take 1 byte per voxel, all others 2, and a spline's coefficients, which only pictures
// at rest want, 2 more; on software GL samples take 2 in any case, for it filters bytes to bytes.
class VolumeMirror {
public:
    // Null where there is no room; notice() then says so. `spline`: coefficients are wanted.
    const MirroredVolume* volume(const Ref<Casting>& data, bool spline);
    void drop_dead();
    std::size_t bytes() const;
    const std::string& notice() const { return notice_; }

private:
    struct FieldEntry {
        std::weak_ptr<const VoxelField> alive;
        MirroredSamples samples;
        std::unique_ptr<MirroredSamples> coefficients;
    };
    struct VolumeEntry {
        std::weak_ptr<const Casting> alive;
        MirroredVolume volume;
    };
    FieldEntry& field(const Ref<VoxelField>& field);
    std::map<const VoxelField*, FieldEntry> fields_;
    std::map<const Casting*, VolumeEntry> volumes_;
    std::string notice_;
};

} // namespace trivar::gpu
