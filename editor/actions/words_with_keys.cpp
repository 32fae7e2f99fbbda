// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/words_with_keys.h"

#include "editor/actions/actions.h"
#include "editor/actions/menus_beside.h"
#include "editor/editor.h"

namespace trivar {
namespace {

// The one whose name the text begins with; the longest, for "Save" begins "Save as...".
const Action* named_at(const Editor& editor, std::string_view text)
{
    const Action* found = nullptr;
    for (const Action& each : editor.actions)
        if (text.starts_with(each.name) && (!found || each.name.size() > found->name.size()))
            found = &each;
    return found;
}

ui::Run key_of(const Action& action)
{
    if (action.keys.empty())
        return {ui::Run::Kind::strong, menu_path(action) + " > " + action.name};
    std::string caps;
    for (const std::string& cap : ui::caps_of(action.keys.front()))
        caps += (caps.empty() ? "" : " ") + cap;
    return {ui::Run::Kind::key, caps};
}

} // namespace

std::vector<ui::Run> with_keys(const Editor& editor, const std::vector<ui::Run>& runs)
{
    std::vector<ui::Run> result;
    for (const ui::Run& run : runs) {
        ui::Run rest = run;
        std::size_t from = 0;
        for (std::size_t at = 0; (at = rest.text.find('@', from)) != std::string::npos;) {
            const Action* action = named_at(editor, std::string_view(rest.text).substr(at + 1));
            from = at + 1;
            if (!action) continue;
            if (at > 0) result.push_back({rest.kind, rest.text.substr(0, at), rest.target});
            result.push_back(key_of(*action));
            rest.text.erase(0, at + 1 + action->name.size());
            from = 0;
        }
        if (!rest.text.empty()) result.push_back(std::move(rest));
    }
    return result;
}

} // namespace trivar
