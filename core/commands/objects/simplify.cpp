// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/simplify.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"

#include <cmath>
#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const Simplify& command)
{
    for (const Id id : distinct(document, command.objects))
        if (!kind_of(document, id).has_surface)
            throw Rejected(named(document, id) +
                           " has no triangles of its own; simplify the objects in it");
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.simplifying = command.simplifying; });
}

StepTitle title(const Simplify& c, const StepDocuments& step)
{
    return {"Simplify " + names_in(step.before, c.objects),
            fmt::format("to {} %", number_text(100 * c.simplifying.keep))};
}

} // namespace trivar
