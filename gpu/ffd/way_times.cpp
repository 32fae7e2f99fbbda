// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/way_times.h"

#include "core/base/rejected.h"
#include "gpu/state_guard.h"

namespace trivar::gpu {

namespace {
constexpr double soon_ms = 20; // a mesh: somebody waits

Way way_of(DeformBy by)
{
    return by == DeformBy::processor   ? Way::processor
           : by == DeformBy::one_phase ? Way::one_phase
                                       : Way::two_phases;
}
} // namespace

WayTime WayTimer::operator()(const Picture& picture, DeformBy by)
{
    WayTime out;
    out.by = by;
    const Way way = way_of(by);
    const Method method = method_of(by);
    const StateGuard guard;
    try {
        if (!timer_) timer_ = std::make_unique<DeformTimer>(soon_ms);
        timer_->take_shaders(picture.shaders);
        for (const Instance& instance : picture.instances) {
            if (instance.stages.empty() || !instance.mesh) continue;
            const Stage& stage = instance.stages.front();
            timer_->take(instance.posed ? *instance.posed->mesh : instance.mesh);
            out.vertices += instance.mesh->vertex_count();
            out.time_ms += timer_->time_ms(stage, way, method);
            if (way != Way::processor)
                out.off =
                    worst(out.off.value_or(DeformErrors{}), timer_->errors(stage, way, method));
            timer_->drop_dead();
        }
    } catch (const Rejected& error) {
        out.why_not = error.what();
    }
    return out;
}

} // namespace trivar::gpu
