// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/play.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"

#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const PlayClip& command)
{
    for (const Id id : distinct(document, command.objects))
        if (!kind_of(document, id).has_clips)
            throw Rejected(named(document, id) + " is not an imported model, so it has no clips");
    const std::vector<Playing>& each = command.playings;
    if (!each.empty() && each.size() != command.objects.size())
        throw Rejected(fmt::format("field \"playings\" has {} entries for {} objects", each.size(),
                                   command.objects.size()));
    for (std::size_t i = 0; i < command.objects.size(); ++i)
        document = with_changed(std::move(document), command.objects[i], [&](Object& o) {
            o.playing = each.empty() ? command.playing : each[i];
        });
    return document;
}

StepTitle title(const PlayClip& c, const StepDocuments& step)
{
    const std::string names = names_in(step.before, c.objects);
    const Object* object = c.objects.empty() ? nullptr : step.was(c.objects.front());
    const Playing old = object ? object->playing : Playing{};
    const Playing& now = c.playings.empty() ? c.playing : c.playings.front();
    if (now.clip.empty()) return {"Let " + names + " stand", {}};
    if (old.clip != now.clip) return {"Let " + names + " play", now.clip};
    return title_of_changes(changes(old, now), "Clip", names);
}

} // namespace trivar
