// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/refine.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

#include <fmt/format.h>

namespace trivar {

void check(const Refining& refining)
{
    if (refining.method == BoundMethod::thesis_circumradius)
        throw Rejected("field \"method\": thesis_circumradius is wrong and bounds nothing; use "
                       "circumradius, its corrected formula");
}

Document applied(Document document, const Refine& command)
{
    for (const Id id : distinct(document, command.objects)) check_bent(document, id);
    const std::vector<Refining>& each = command.refinings;
    if (!each.empty() && each.size() != command.objects.size())
        throw Rejected(fmt::format("field \"refinings\" has {} entries for {} objects", each.size(),
                                   command.objects.size()));
    check(command.refining);
    for (const Refining& one : each) check(one);
    for (std::size_t i = 0; i < command.objects.size(); ++i)
        document = with_changed(std::move(document), command.objects[i], [&](Object& o) {
            o.refining = each.empty() ? command.refining : each[i];
        });
    return document;
}

StepTitle title(const Refine& c, const StepDocuments& step)
{
    const Refining& now = c.refinings.empty() ? c.refining : c.refinings.front();
    return {"Refine " + names_in(step.before, c.objects), in_metres(now.tolerance)};
}

} // namespace trivar
