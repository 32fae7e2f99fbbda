// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/key_presets.h"

#include "editor/actions/chords.h"

namespace trivar {

const std::vector<KeyPreset>& key_presets()
{
    // Orbiting with Alt is everywhere.
    static const std::vector<KeyPreset> presets{
        {"Trivar", {}},
        {"Maya-like",
         {{"Select", {{'Q'}}},
          {"Move", {{'W'}}},
          {"Rotate", {{'E'}}},
          {"Scale", {{'R'}}},
          {"Frame selection", {{'F'}}},
          {"Frame all", {{'A'}}},
          {"Select all", {ctrl('A', true)}},
          {"Invert selection", {ctrl('I', true)}},
          {"Import model...", {}},
          {"Undo", {ctrl('Z'), {'Z'}}},
          {"Redo", {ctrl('Z', true), {.key = 'Z', .shift = true}}},
          {"Duplicate", {ctrl('D')}},
          {"Repeat last", {{'G'}}},
          {"Hide or show", {{'H'}, ctrl('H')}}}},
        {"3ds Max-like",
         {{"Select", {{'Q'}}},
          {"Move", {{'W'}}},
          {"Rotate", {{'E'}}},
          {"Scale", {{'R'}}},
          {"Frame selection", {{'Z'}}},
          {"Frame all", {ctrl('Z', true)}},
          {"Redo", {ctrl('Y')}},
          {"Select all", {ctrl('A')}},
          {"Deselect all", {ctrl('D')}},
          {"Front", {{'F'}}},
          {"Top", {{'T'}}},
          {"Perspective", {{'P'}}},
          {"Place", {{'D'}}},
          {"Duplicate", {ctrl('V')}}}}};
    return presets;
}

} // namespace trivar
