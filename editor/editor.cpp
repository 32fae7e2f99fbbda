// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/editor.h"

namespace trivar {

Editor::Editor(std::function<void()> wake, std::vector<Action> table_of_actions,
               std::string unnamed_folder, OnFailure manner)
    : on_failure(manner),
      session(wake, std::move(unnamed_folder), manner),
      actions(std::move(table_of_actions)),
      recording(wake, session.notices),
      frames_export(wake, session.notices),
      stored_pictures(wake)
{
}

void Editor::lose_context()
{
    viewport.forget_gpu();
    picture_to_file.forget_gpu();
    recording.forget_gpu();
    stored_pictures.forget_gpu();
    session.notices.say(ui::NoticeKind::warning, "The graphics card was reset",
                        "The picture is being redrawn. Nothing in the scene is lost.");
}

void Editor::choose_tool(std::size_t index)
{
    if (index == tool) return;
    active_tool().cancel(session);
    tool = index;
}

void Editor::choose_tool(std::string_view name)
{
    for (std::size_t i = 0; i < tools.size(); ++i)
        if (tools[i]->name() == name) return choose_tool(i);
}

} // namespace trivar
