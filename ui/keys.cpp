// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/keys.h"

#include <imgui.h>

namespace trivar::ui {
namespace {

std::string name_of(int key)
{
    if (key > key_f1 - 1 && key < key_f1 + 12) return "F" + std::to_string(key - key_f1 + 1);
    switch (key) {
    case key_space: return "Space";
    case key_escape: return "Esc";
    case key_enter: return "Enter";
    case key_tab: return "Tab";
    case key_backspace: return "Backspace";
    case key_delete: return "Del";
    case key_home: return "Home";
    default: return std::string(1, static_cast<char>(key));
    }
}

} // namespace

std::string text_of(const Chord& chord)
{
    return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.alt ? "Alt+" : "") +
           (chord.shift ? "Shift+" : "") + name_of(chord.key);
}

bool struck(const Chord& chord)
{
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && chord.key > 0 && io.KeyCtrl == chord.ctrl &&
           io.KeyShift == chord.shift && io.KeyAlt == chord.alt &&
           ImGui::IsKeyPressed(chord.key, false);
}

} // namespace trivar::ui
