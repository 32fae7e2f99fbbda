// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/noise.h"

#include "core/commands/edits.h"
#include "core/commands/field_words.h"

namespace trivar {

Document applied(Document document, const AddNoise& command)
{
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.noise = command.noise; });
}

StepTitle title(const AddNoise& c, const StepDocuments& step)
{
    return {"Shift vertices of " + names_in(step.before, c.objects), in_metres(c.noise.amount)};
}

} // namespace trivar
