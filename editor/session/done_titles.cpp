// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/done_titles.h"

#include "core/commands/every_command.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/warp.h"
#include "editor/words/volume_words.h"

#include <algorithm>

namespace trivar {
namespace {

// Returns the result of a step that shaped an object; null: it is not known now.
const Shaping* outcome_of(const Session& session, Id id, const Ref<VolumeEdit>& edit)
{
    const Document& seen = session.previewing() ? session.shown() : session.committed();
    const auto object = seen.objects.find(id);
    const auto effects = session.evaluated().objects.find(id);
    if (object == seen.objects.end() || effects == session.evaluated().objects.end() ||
        !effects->second->shaped)
        return nullptr;
    const std::vector<Ref<VolumeEdit>>& steps = object->second->shaping;
    const std::vector<Shaping>& done = effects->second->shaped->steps;
    const auto at = static_cast<std::size_t>(std::ranges::find(steps, edit) - steps.begin());
    return at < steps.size() && at < done.size() ? &done[at] : nullptr;
}

// The step that the command made or changed, counted from 0, among those of its object.
std::size_t index_made_by(const WarpVolume&, const Object& after)
{
    return after.shaping.size() - 1;
}
std::size_t index_made_by(const MovePoints&, const Object& after)
{
    return after.shaping.size() - 1;
}
std::size_t index_made_by(const SetWarp& command, const Object&)
{
    return static_cast<std::size_t>(command.step) - 1;
}

void take_done(WarpVolume& command, const VolumeEdit& done)
{
    if (done.warp) command.warp = *done.warp;
}
void take_done(MovePoints& command, const VolumeEdit& done)
{
    if (done.shift) command.shift = *done.shift;
}
void take_done(SetWarp& command, const VolumeEdit& done)
{
    if (done.warp) command.warp = *done.warp;
}

} // namespace

StepTitle done_title(const Session& session, const Command& command, const Document& before,
                     const Document& after)
{
    Command done = command;
    const auto limit = [&]<class C>(C& c) {
        if constexpr (requires(const Object& o) { index_made_by(c, o); }) {
            const auto object = after.objects.find(c.object);
            if (object == after.objects.end()) return;
            const std::size_t at = index_made_by(c, *object->second);
            if (at >= object->second->shaping.size()) return;
            const Ref<VolumeEdit>& edit = object->second->shaping[at];
            if (const Shaping* outcome = outcome_of(session, c.object, edit))
                take_done(c, as_done(*edit, *outcome));
        }
    };
    change(done, limit);
    return step_title(done, before, after);
}

} // namespace trivar
