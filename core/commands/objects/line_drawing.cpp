// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/line_drawing.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"

namespace trivar {

Document applied(Document document, const SetLineDrawing& command)
{
    for (const Id id : distinct(document, command.objects)) check_has_surface(document, id, "draw");
    if (command.drawing.more.light == glm::vec3(0))
        throw Rejected("the light of isophotes needs a direction other than 0, 0, 0");
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.line_drawing = command.drawing; });
}

StepTitle title(const SetLineDrawing& c, const StepDocuments& step)
{
    const Object* object = c.objects.empty() ? nullptr : step.was(c.objects.front());
    const std::string names = names_in(step.before, c.objects);
    if (!object || !object->line_drawing) return {"Draw " + names + " in lines", {}};
    return title_of_changes(changes(*object->line_drawing, c.drawing), "Lines", names);
}

} // namespace trivar
