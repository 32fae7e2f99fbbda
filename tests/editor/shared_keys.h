// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

#include <map>

namespace trivar::testing {

// The keys that two actions have in one place, with the names of both.
inline std::vector<std::string> shared_keys(const std::vector<Action>& actions)
{
    std::vector<std::string> shared;
    std::multimap<std::string, const Action*> taken;
    for (const Action& each : actions)
        for (const ui::Chord& chord : each.keys) {
            const std::string key = ui::text_of(chord);
            const auto [first, last] = taken.equal_range(key);
            for (auto other = first; other != last; ++other)
                if (meet(each.keys_in, other->second->keys_in))
                    shared.push_back(key + ": " + each.name + ", " + other->second->name);
            taken.emplace(key, &each);
        }
    return shared;
}

} // namespace trivar::testing
