// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/lent_tool.h"

#include "editor/editor.h"
#include "editor/tools/place/place.h"
#include "ui/input.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

struct LentTool {
    int key = 0;  // that is held for it; 0: none
    Id model = 0; // that it is to lay; 0: none
    long scene = 0;
    std::size_t tool = 0, before = 0;
    bool used = false; // by the mouse
};

// Whether it was laid, or there is nothing to lay any more.
bool is_done(const Session& session, Id model)
{
    const auto& objects = session.committed().objects;
    const auto found = objects.find(model);
    return found == objects.end() || found->second->stroke;
}

} // namespace

void lend_tool_while_held(Editor& editor, int key, std::size_t before)
{
    auto& lent = editor.memory.of<LentTool>();
    if (lent.model != 0 && editor.tool == lent.tool) return;
    lent = {};
    if (editor.tool != before) lent = {.key = key, .tool = editor.tool, .before = before};
}

void lend_place(Editor& editor, Id model)
{
    const auto place = std::ranges::find(editor.tools, std::string("Place"), &Tool::name);
    const auto index = static_cast<std::size_t>(place - editor.tools.begin());
    if (place == editor.tools.end() || editor.active_tool().busy()) return;
    dynamic_cast<PlaceTool&>(**place).take_up(editor.session, model);
    if (index == editor.tool) return;
    editor.memory.of<LentTool>() = {
        .model = model, .scene = editor.session.scenes(), .tool = index, .before = editor.tool};
    editor.choose_tool(index);
}

void return_lent_tool(Editor& editor)
{
    auto& lent = editor.memory.of<LentTool>();
    const bool busy = editor.active_tool().busy();
    if (lent.model != 0) {
        const bool done =
            lent.scene != editor.session.scenes() || is_done(editor.session, lent.model);
        if (editor.tool == lent.tool && (busy || !done)) return;
        if (editor.tool == lent.tool) editor.choose_tool(lent.before);
        lent = {};
    }
    if (lent.key == 0) return;
    if (ui::is_down(lent.key)) {
        lent.used = lent.used || (busy && ImGui::IsMouseDown(ImGuiMouseButton_Left));
    } else if (!busy) {
        if (lent.used) editor.choose_tool(lent.before);
        lent = {};
    }
}

} // namespace trivar
