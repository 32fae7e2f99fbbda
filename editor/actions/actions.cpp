// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"

#include "core/base/mistake.h"
#include "editor/editor.h"
#include "ui/sentence.h"

namespace trivar {

Condition something_selected()
{
    return {[](const Editor& e) { return e.session.selected != 0; }, "select an object first"};
}

Condition something_there()
{
    return {[](const Editor& e) { return !e.session.document().objects.empty(); },
            "the scene is empty"};
}

const Action& action(const Editor& editor, const std::string& name)
{
    for (const Action& each : editor.actions)
        if (each.name == name) return each;
    throw Mistake("there is no action of this name: " + name);
}

bool is_enabled(const Editor& editor, const Action& action)
{
    return !action.enabled.holds || action.enabled.holds(editor);
}

std::string key_text(const Action& action)
{
    return action.keys.empty() ? std::string() : ui::text_of(action.keys.front());
}

ui::Tip tip_of(const Editor& editor, const Action& action, std::string sentence)
{
    if (!is_enabled(editor, action))
        sentence += (sentence.empty() ? "" : " ") + ui::sentence(action.enabled.otherwise);
    return {action.name, key_text(action), std::move(sentence)};
}

} // namespace trivar
