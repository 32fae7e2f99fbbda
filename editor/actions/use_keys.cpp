// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/use_keys.h"

#include "editor/editor.h"

#include <algorithm>

namespace trivar {
namespace {

std::vector<std::string> give(std::vector<Action>& actions, const std::string& name,
                              const std::vector<ui::Chord>& keys)
{
    std::vector<std::string> losers;
    const auto owner = std::ranges::find(actions, name, &Action::name);
    const KeysIn in = owner == actions.end() ? KeysIn::anywhere : owner->keys_in;
    for (Action& each : actions) {
        if (each.name == name) {
            each.keys = keys;
            continue;
        }
        const auto lost = [&](const ui::Chord& chord) {
            return std::ranges::find(keys, chord) != keys.end();
        };
        if (meet(each.keys_in, in) && std::erase_if(each.keys, lost) > 0)
            losers.push_back(each.name);
    }
    return losers;
}

} // namespace

KeyMap changed_keys(const std::vector<Action>& actions)
{
    KeyMap map;
    for (const Action& each : actions)
        if (each.keys != each.usual_keys) map[each.name] = each.keys;
    return map;
}

void use_keys(std::vector<Action>& actions, const KeyMap& map)
{
    for (Action& each : actions) {
        const auto found = map.find(each.name);
        each.keys = found == map.end() ? each.usual_keys : found->second;
    }
    // Another action may have been given what is usual here.
    for (Action& each : actions)
        if (!map.contains(each.name))
            std::erase_if(each.keys, [&](const ui::Chord& chord) {
                return std::ranges::any_of(actions, [&](const Action& other) {
                    const auto changed = map.find(other.name);
                    return changed != map.end() && meet(each.keys_in, other.keys_in) &&
                           std::ranges::find(changed->second, chord) != changed->second.end();
                });
            });
}

std::vector<std::string> give_key(std::vector<Action>& actions, const std::string& name,
                                  const ui::Chord& chord)
{
    return give(actions, name, {chord});
}

std::vector<std::string> give_usual_keys(std::vector<Action>& actions, const std::string& name)
{
    const auto found = std::ranges::find(actions, name, &Action::name);
    if (found == actions.end()) return {};
    return give(actions, name, std::vector(found->usual_keys));
}

void ask_for_key(Editor& editor, const std::string& action)
{
    auto& dialog = editor.preferences_dialog;
    dialog = {};
    dialog.open = dialog.show_asking = true;
    dialog.page = dialog.of_keys;
    dialog.asking = action;
}

} // namespace trivar
