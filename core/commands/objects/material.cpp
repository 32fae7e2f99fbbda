// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/material.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"

#include <fmt/format.h>

namespace trivar {
namespace {

Document with_surfacing(Document document, const std::vector<Id>& ids,
                        const std::optional<Surfacing>& surfacing)
{
    for (const Id id : distinct(document, ids))
        if (!kind_of(document, id).takes_material)
            throw Rejected(named(document, id) +
                           " is a group; give materials to the objects in it");
    return with_all_changed(std::move(document), ids, [&](Object& o) { o.surfacing = surfacing; });
}

} // namespace

Document applied(Document document, const SetMaterial& command)
{
    return with_surfacing(std::move(document), command.objects, command.surfacing);
}

StepTitle title(const SetMaterial& c, const StepDocuments& step)
{
    const Object* object = c.objects.empty() ? nullptr : step.was(c.objects.front());
    const std::string names = names_in(step.before, c.objects);
    if (!object || !object->surfacing) return {"Give " + names + " a plain material", {}};
    return title_of_changes(changes(*object->surfacing, c.surfacing), "Material", names);
}

Document applied(Document document, const ClearMaterial& command)
{
    return with_surfacing(std::move(document), command.objects, std::nullopt);
}

StepTitle title(const ClearMaterial& c, const StepDocuments& step)
{
    const bool one = c.objects.size() == 1;
    return {fmt::format("Give {} {} own material back", names_in(step.before, c.objects),
                        one ? "its" : "their"),
            {}};
}

} // namespace trivar
