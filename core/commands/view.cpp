// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/apply.h"
#include "core/commands/check.h"
#include "core/document/check_view.h"

#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const SaveCamera& command)
{
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    check_view(command.camera);
    document.bookmarks.insert_or_assign(command.name, command.camera);
    return document;
}

Document applied(Document document, const DeleteCamera& command)
{
    if (document.bookmarks.erase(command.name) == 0)
        throw Rejected("there is no point of view named \"" + excerpt(command.name) + "\"");
    return document;
}

Document applied(Document document, const SetRender& command)
{
    document.render = make_ref(command.settings);
    return document;
}

Document applied(Document document, const SetTime& command)
{
    if (command.time.last_frame < command.time.first_frame)
        throw Rejected(fmt::format("field \"last_frame\" is {}, before the first frame, {}",
                                   command.time.last_frame, command.time.first_frame));
    document.time = command.time;
    return document;
}

} // namespace trivar
