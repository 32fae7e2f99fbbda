// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/apply_shape.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/placement/place.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

bool carried_by(const Object& rider, Id host)
{
    return rider.stroke && rider.stroke->attach &&
           std::ranges::find(rider.stroke->attach->hosts, host, &AttachedHost::object) !=
               rider.stroke->attach->hosts.end();
}

void check_riders(const Document& document, const ApplyShape& command)
{
    if (command.riders.empty() && command.strokes.empty() && command.attach.empty()) return;
    distinct(document, command.riders);
    if (command.strokes.size() != command.riders.size() ||
        command.attach.size() != command.riders.size())
        throw Rejected(fmt::format("fields \"strokes\" and \"attach\" have {} and {} entries for "
                                   "{} riders; give one of each per rider",
                                   command.strokes.size(), command.attach.size(),
                                   command.riders.size()));
    for (const Id id : command.riders)
        if (!carried_by(object(document, id), command.object))
            throw Rejected(fmt::format("field \"riders\": {} is not attached to {}",
                                       named(document, id), named(document, command.object)));
}

} // namespace

Document applied(Document document, const ApplyShape& command)
{
    const Object& laid = object(document, command.object);
    check_placed(laid, command.object);
    if (!kind_of(laid).has_surface)
        throw Rejected("field \"object\": " + named(document, command.object) +
                       " has no shape of its own");
    if (command.file.path.empty()) throw Rejected("field \"path\" names no file");
    check_transform(command.transform);
    check_riders(document, command);
    std::vector<Id> others;
    for (const auto& [id, each] : document.objects)
        if (carried_by(*each, command.object) && std::ranges::count(command.riders, id) == 0)
            others.push_back(id);
    for (const Id id : others)
        document =
            with_changed(std::move(document), id, [](Object& o) { o.stroke->attach.reset(); });
    for (std::size_t i = 0; i < command.riders.size(); ++i)
        document = applied(std::move(document),
                           EditPlacement{command.riders[i],
                                         object(document, command.riders[i]).stroke->parameters,
                                         command.strokes[i],
                                         {},
                                         command.attach[i]});
    return with_changed(std::move(document), command.object, [&](Object& o) {
        o = {.name = o.name,
             .source = command.file,
             .transform = command.transform,
             .surfacing = o.surfacing,
             .parent = o.parent,
             .hidden = o.hidden,
             .locked = o.locked,
             .stroke = {}};
    });
}

StepTitle title(const ApplyShape& c, const StepDocuments& step)
{
    return {"Make the shape of " + name_in(step.before, c.object) + " final",
            c.tolerance > 0 ? in_metres(c.tolerance) : std::string()};
}

} // namespace trivar
