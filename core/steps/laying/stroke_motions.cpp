// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/stroke_motions.h"

#include "core/steps/laying/carried_samples.h"
#include "core/steps/laying/host_motion.h"

#include <algorithm>

namespace trivar {
namespace {

// Whether the stroke lay on the ground and on no object when it was attached.
bool is_on_ground_alone(const PlacementStep& step)
{
    return step.parameters.on_ground && step.attach->samples.empty() && !carries(*step.attach);
}

// Sets the transforms of the hosts in the space of the stroke, and the parts that it may fall on.
void stand(StrokeMotion& stroke_motion, StrokeHosts& stroke, bool exact)
{
    const glm::dmat4 back = glm::inverse(stroke_motion.to_world);
    for (HostNow& now : stroke.hosts) {
        if (!now.object) continue;
        now.unmoved = exact && (now.moved == stroke_motion.to_world ||
                                alike(stroke, now.moved, stroke_motion.to_world));
        now.own_to_drawn = now.unmoved ? now.stood : back * now.object->own_to_world;
        if (!now.unmoved && !now.host->touched) continue;
        for (Part part : now.parts) {
            part.to_world = now.own_to_drawn * part.to_world;
            stroke_motion.supports.push_back(
                support_of(*now.object, std::move(part), now.own_to_drawn));
        }
    }
}

// Makes the stroke_motion of a step; `others` are the objects that it lies on without being
// attached.
StrokeMotion carriage_of(const PlacementStep& step, StrokeHosts stroke,
                         const std::vector<Ref<EvaluatedObject>>& others, const GroundPlane& ground)
{
    StrokeMotion out;
    out.sketch = step.sketch;
    const bool stays = is_on_ground_alone(step);
    if (!stays && !stroke.main_host().object) {
        out.shown = false;
        out.notices.emplace_back("its host is not visible in this frame");
        return out;
    }
    const HostMotion motion = stays ? HostMotion{.exact = true} : motion_of(stroke);
    out.to_world = motion.to_world;
    stand(out, stroke, motion.exact);
    if (!stays) carry_samples(out, stroke);
    if (!out.moved()) // other objects are met only while nothing has moved
        for (const Ref<EvaluatedObject>& other : others)
            if (other)
                for (const Part& part : other->parts)
                    out.supports.push_back(support_of(*other, part, other->own_to_world));
    if (step.parameters.on_ground)
        if (const auto under = ground.under(out.sketch, out.to_world))
            out.supports.push_back(*under);
    return out;
}

} // namespace

Support support_of(const EvaluatedObject& object, Part part, const glm::dmat4& own_to_drawn)
{
    const Ref<Mesh> rest = rest_mesh(*object.shape, part.key.mesh);
    return {object.id, std::move(part), rest, own_to_drawn};
}

Ref<StrokeMotion> StrokeMotions::operator()(const StepInput& input)
{
    const std::optional<PlacementStep>& step = input.object.stroke;
    if (!step || !step->attach || step->round) return nullptr;
    if (!carries(*step->attach) && !is_on_ground_alone(*step)) return nullptr;
    From from{*step, {}, {}};
    const auto done = [&](Id id) {
        const auto found = input.done.find(id);
        return found == input.done.end() ? nullptr : found->second;
    };
    for (const AttachedHost& host : step->attach->hosts) from.hosts.push_back(done(host.object));
    for (const Id id : step->onto)
        if (std::ranges::find(step->attach->hosts, id, &AttachedHost::object) ==
            step->attach->hosts.end())
            from.others.push_back(done(id));
    return known_(from, [&] {
        const Attachment& attachment = *from.step.attach;
        return make_ref(carriage_of(from.step,
                                    stroke_hosts(attachment, from.hosts, anchors_, input),
                                    from.others, ground_));
    });
}

} // namespace trivar
