// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/view.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"
#include "core/document/check_view.h"

#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const KeepView& command)
{
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    check_view(command.camera);
    document.kept_views.insert_or_assign(command.name, command.camera);
    return document;
}

StepTitle title(const KeepView& c, const StepDocuments& step)
{
    if (c.name == "picture") return {"Set render camera to view", {}};
    return {(step.before.kept_views.contains(c.name) ? "Aim " : "Keep ") + c.name, {}};
}

Document applied(Document document, const ForgetView& command)
{
    if (document.kept_views.erase(command.name) == 0)
        throw Rejected("there is no bookmark named \"" + excerpt(command.name) + "\"");
    return document;
}

StepTitle title(const ForgetView& c, const StepDocuments&)
{
    return {"Forget " + c.name, {}};
}

Document applied(Document document, const SetRender& command)
{
    document.render = make_ref(command.settings);
    return document;
}

StepTitle title(const SetRender& c, const StepDocuments& step)
{
    return title_of_changes(changes(*step.before.render, c.settings), "Picture settings", {});
}

Document applied(Document document, const SetTime& command)
{
    if (command.time.last_frame < command.time.first_frame)
        throw Rejected(fmt::format("field \"last_frame\" is {}, before the first frame, {}",
                                   command.time.last_frame, command.time.first_frame));
    document.time = command.time;
    return document;
}

StepTitle title(const SetTime& c, const StepDocuments& step)
{
    return title_of_changes(changes(step.before.time, c.time), "Frames", {});
}

} // namespace trivar
