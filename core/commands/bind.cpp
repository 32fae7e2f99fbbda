// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/bind.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/words/field_words.h"
#include "core/document/bases.h"

#include <algorithm>

namespace trivar {
namespace {

Object bound(const Object& before, const Bind& command)
{
    const std::vector<Id>& from = command.from;
    const auto with = [&](Id to) {
        return with_bases(before, [&](Id base) {
            return std::ranges::find(from, base) == from.end() ? base : to;
        });
    };
    Object o = with(command.to);
    if (o.stroke && std::ranges::find(before.stroke->onto, command.to) != before.stroke->onto.end())
        o.stroke = with(0).stroke; // it goes with the rest of what carried it
    if (from.empty() && o.stroke && o.stroke->onto.empty()) o.stroke->onto = {command.to};
    if (from.empty() && o.tiles && o.tiles->base == 0) o.tiles->base = command.to;
    return o;
}

} // namespace

Document applied(Document document, const Bind& command)
{
    if (!kind_of(document, command.to).has_surface)
        throw Rejected(named(document, command.to) +
                       " has no shape of its own; choose an object that has");
    for (const Id id : distinct(document, command.objects)) {
        const Ref<Object> before = document.objects.at(id);
        if (depending_on(document, {id}).contains(command.to))
            throw Rejected(named(document, command.to) + " is or depends on " + named(id, *before) +
                           " itself; choose another object");
        Object now = bound(*before, command);
        if (now == *before)
            throw Rejected(named(id, *before) + " depends on none of these objects");
        const std::optional<Tiling> tiling = std::exchange(now.tiles, std::nullopt);
        document.objects.set(id, make_ref(std::move(now)));
        if (!tiling) continue;
        document = with_tiling(std::move(document), id, *tiling); // which checks what it is on
        if (tiling->others != before->tiles->others)
            document = with_mix(std::move(document), id, tiling->weight, tiling->others);
        if (tiling->into != before->tiles->into)
            document = applied(std::move(document), MorphTiles{id, tiling->into});
    }
    return document;
}

StepTitle title(const Bind& c, const StepDocuments& step)
{
    return {"Bind " + names_in(step.before, c.objects) + " to " + name_in(step.after, c.to), {}};
}

} // namespace trivar
