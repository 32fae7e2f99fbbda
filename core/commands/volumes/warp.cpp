// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/warp.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/shape.h"
#include "core/commands/words/changes.h"

#include <fmt/format.h>

namespace trivar {
namespace {

void check_lattice(const Document& document, Id id)
{
    if (!is_lattice(document, id))
        throw Rejected(fmt::format("field \"object\": {} ({}) is not a lattice", id,
                                   object(document, id).name));
}

// Returns the warp in a step; null if there is no such step, or it is of another kind.
const Warp* warp_of(const Object& o, int step)
{
    if (step < 1 || static_cast<std::size_t>(step) > o.shaping.size()) return nullptr;
    const std::optional<Warp>& warp = o.shaping[static_cast<std::size_t>(step) - 1]->warp;
    return warp ? &*warp : nullptr;
}

} // namespace

Document applied(Document document, const WarpVolume& command)
{
    check_lattice(document, command.object);
    return with_step(std::move(document), command.object, {.warp = command.warp});
}

StepTitle title(const WarpVolume& c, const StepDocuments& step)
{
    return title_of_changes(changes(Warp{.axis = c.warp.axis, .fixed = c.warp.fixed}, c.warp),
                            "Bend", name_in(step.before, c.object));
}

Document applied(Document document, const SetWarp& command)
{
    check_lattice(document, command.object);
    const Object& o = object(document, command.object);
    if (!warp_of(o, command.step))
        throw Rejected(fmt::format("field \"step\": step {} of {} is not a warp", command.step,
                                   named(command.object, o)));
    return with_changed(std::move(document), command.object, [&](Object& changed) {
        changed.shaping[static_cast<std::size_t>(command.step) - 1] =
            make_ref(VolumeEdit{.warp = command.warp});
    });
}

StepTitle title(const SetWarp& c, const StepDocuments& step)
{
    const Object* object = step.was(c.object);
    const Warp* old = object ? warp_of(*object, c.step) : nullptr;
    return title_of_changes(old ? changes(*old, c.warp) : Changes{}, "Warp",
                            name_in(step.before, c.object));
}

} // namespace trivar
