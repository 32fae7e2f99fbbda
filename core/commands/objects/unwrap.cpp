// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/unwrap.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

namespace trivar {

Document applied(Document document, const Unwrap& command)
{
    for (const Id id : distinct(document, command.objects))
        check_has_surface(document, id, "unwrap");
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.unwrapping = command.unwrapping; });
}

StepTitle title(const Unwrap& c, const StepDocuments& step)
{
    return {"Unwrap " + names_in(step.before, c.objects), {}};
}

} // namespace trivar
