// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <functional>
#include <string>
#include <vector>

namespace trivar {

struct Editor;

// A Condition is whether an action can run, and if not the missing thing: "select an object first".
struct Condition {
    Condition() = default;
    template <class Holds>
    Condition(Holds when, std::string missing = {})
        : holds(std::move(when)),
          otherwise(std::move(missing))
    {
    }
    std::function<bool(const Editor&)> holds; // empty: always
    std::string otherwise;
};

// KeysIn says where keys count. `picture`: while no tutorial runs and no list has the keyboard.
enum class KeysIn { anywhere, picture, tutorial };
constexpr bool meet(KeysIn a, KeysIn b)
{
    return a == b || a == KeysIn::anywhere || b == KeysIn::anywhere;
}

// An Action is something that can be done from a menu or by a key. The one table of actions makes
// menus, keys, tooltips and the list of keys in Help.
struct Action {
    std::string menu, name;
    std::vector<ui::Chord> keys; // the first is shown
    std::function<void(Editor&)> run;
    Condition enabled = {};
    bool group_begins = false;              // a rule above it in the menu
    std::vector<ui::Chord> usual_keys = {}; // before a person changed them
    KeysIn keys_in = KeysIn::anywhere;
    bool repeats = false;                       // while its key is held
    std::function<bool(const Editor&)> on = {}; // for a switch: whether it has a tick
};

} // namespace trivar
