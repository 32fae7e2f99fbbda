// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/way_times.h"

#include "core/base/rejected.h"
#include "gpu/state_guard.h"

namespace trivar::gpu {

namespace {
constexpr double soon_ms = 20; // a mesh: somebody waits
}

WayTime WayTimer::operator()(const Picture& picture, DeformBy by)
{
    WayTime out;
    out.by = by;
    const Method method = method_of(by);
    const StateGuard guard;
    try {
        if (!timer_) timer_ = std::make_unique<DeformTimer>(soon_ms);
        for (const Instance& instance : picture.instances) {
            if (instance.stages.empty() || !instance.mesh) continue;
            const Stage& stage = instance.stages.front();
            timer_->take(instance.mesh);
            out.vertices += instance.mesh->vertex_count();
            if (by == DeformBy::processor)
                out.time_ms += timer_->processor_ms(stage, method);
            else if (by == DeformBy::one_phase)
                out.time_ms += timer_->one_phase_ms(stage, method);
            else {
                out.time_ms += timer_->two_phases_ms(stage, method);
                const DeformErrors off = timer_->errors(stage, method);
                const DeformErrors worst = out.off.value_or(DeformErrors{});
                out.off = {std::max(worst.position, off.position),
                           std::max(worst.normal_deg, off.normal_deg)};
            }
            timer_->drop_dead();
        }
    } catch (const Rejected& error) {
        out.why_not = error.what();
    }
    return out;
}

} // namespace trivar::gpu
