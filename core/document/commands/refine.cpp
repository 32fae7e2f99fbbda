// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/commands/refine.h"

#include "core/base/rejected.h"
#include "core/document/commands/apply.h"

namespace trivar {

Document applied(Document document, const Refine& command)
{
    for (const Id id : distinct(document, command.objects)) check_placed(object(document, id), id);
    if (command.refining.method == BoundMethod::thesis_circumradius)
        throw Rejected("field \"method\": thesis_circumradius is false and bounds nothing; "
                       "circumradius is the same formula put right");
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.refining = command.refining; });
}

Document applied(Document document, const ClearRefine& command)
{
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.refining.reset(); });
}

} // namespace trivar
