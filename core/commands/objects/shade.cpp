// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/shade.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

#include <array>
#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const Shade& command)
{
    for (const Id id : distinct(document, command.objects))
        if (!kind_of(document, id).has_surface)
            throw Rejected(named(document, id) +
                           " has no faces of its own; shade the objects in it");
    return with_all_changed(std::move(document), command.objects, [&](Object& o) {
        o.shading = command.shading;
        if (o.shading->way == ShadingWay::own) o.shading.reset();
    });
}

StepTitle title(const Shade& c, const StepDocuments& step)
{
    static constexpr std::array ways{"as it was made", "smooth", "by angle", "flat"};
    return {fmt::format("Shade {} {}", names_in(step.before, c.objects),
                        ways.at(static_cast<std::size_t>(c.shading.way))),
            c.shading.way == ShadingWay::by_angle ? in_degrees(c.shading.angle_deg) : ""};
}

} // namespace trivar
