// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/keep_shape.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/group.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
Document applied(Document document, const KeepShape& command)
{
    if (!is_lattice(document, command.object))
        throw Rejected("field \"object\": " + named(document, command.object) +
                       " is not a lattice");
    distinct(document, command.members);
    if (command.members.size() != command.files.size())
        throw Rejected(fmt::format("field \"files\" names {} files for {} members; give one each",
                                   command.files.size(), command.members.size()));
    for (std::size_t i = 0; i < command.members.size(); ++i) {
        const Id id = command.members[i];
        if (std::ranges::count(lattices_round(document, id), command.object) == 0)
            throw Rejected(fmt::format("field \"members\": {} is not in {}", named(document, id),
                                       named(document, command.object)));
        if (!kind_of(document, id).has_surface)
            throw Rejected("field \"members\": " + named(document, id) +
                           " has no shape of its own");
        if (command.files[i].path.empty()) throw Rejected("field \"path\" names no file");
    }
    document = applied(std::move(document), Ungroup{command.object});
    for (std::size_t i = 0; i < command.members.size(); ++i)
        document = with_changed(std::move(document), command.members[i], [&](Object& o) {
            o = {.name = o.name,
                 .source = command.files[i],
                 .transform = {},
                 .surfacing = o.surfacing,
                 .parent = o.parent,
                 .hidden = o.hidden,
                 .locked = o.locked,
                 .stroke = {}};
        });
    return document;
}

StepTitle title(const KeepShape& c, const StepDocuments& step)
{
    return {"Delete " + name_in(step.before, c.object) + " and keep its shape", {}};
}

} // namespace trivar
