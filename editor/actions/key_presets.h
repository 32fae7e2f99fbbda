// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/preferences/key_map.h"

namespace trivar {

// Key maps as people know them from elsewhere; the first one is Trivar's own and changes nothing.
struct KeyPreset {
    std::string name;
    KeyMap keys;
};
const std::vector<KeyPreset>& key_presets();

} // namespace trivar
