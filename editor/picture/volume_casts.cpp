// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_casts.h"

#include "core/stages/shown_volume.h"

namespace trivar {

std::optional<gpu::CastVolume> cast_volume_of(const EvaluatedObject& object)
{
    if (!object.shape || !object.shape->volume) return std::nullopt;
    const ShownVolume& volume = *object.shape->volume;
    const Box box = volume.cast_box();
    if (box.empty()) return std::nullopt;
    return gpu::CastVolume{.data = volume.casting,
                           .to_world = object.own_to_world * volume.all_to_model(),
                           .low = box.lo,
                           .high = box.hi,
                           .density = static_cast<float>(volume.seen_as.density),
                           .shading = static_cast<float>(volume.seen_as.shading),
                           .id = object.id};
}

} // namespace trivar
