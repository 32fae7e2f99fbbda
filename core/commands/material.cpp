// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/apply.h"

#include <fmt/format.h>

namespace trivar {
namespace {

Document with_surfacing(Document document, const std::vector<Id>& ids,
                        const std::optional<Surfacing>& surfacing)
{
    for (const Id id : distinct(document, ids))
        if (const Object& o = object(document, id); holds_others(o.source))
            throw Rejected(named(id, o) + " is a group; give materials to the objects in it");
    return with_all_changed(std::move(document), ids, [&](Object& o) { o.surfacing = surfacing; });
}

} // namespace

Document applied(Document document, const SetMaterial& command)
{
    return with_surfacing(std::move(document), command.objects, command.surfacing);
}

Document applied(Document document, const ClearMaterial& command)
{
    return with_surfacing(std::move(document), command.objects, std::nullopt);
}

} // namespace trivar
