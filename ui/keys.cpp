// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/keys.h"

#include <imgui.h>

namespace trivar::ui {
namespace {

std::string name_of(int key)
{
    if (key > key_f1 - 1 && key < key_f1 + 12) return "F" + std::to_string(key - key_f1 + 1);
    if (key >= key_keypad_0 && key < key_keypad_0 + 10)
        return "Keypad " + std::to_string(key - key_keypad_0);
    switch (key) {
    case key_space: return "Space";
    case key_escape: return "Esc";
    case key_enter: return "Enter";
    case key_tab: return "Tab";
    case key_backspace: return "Backspace";
    case key_delete: return "Del";
    case key_home: return "Home";
    case key_insert: return "Ins";
    case key_page_up: return "Page up";
    case key_page_down: return "Page down";
    case key_end: return "End";
    case key_left: return "Left";
    case key_right: return "Right";
    case key_up: return "Up";
    case key_down: return "Down";
    case key_keypad_divide: return "Keypad /";
    case key_keypad_minus: return "Keypad -";
    case key_keypad_plus: return "Keypad +";
    case key_keypad_enter: return "Keypad Enter";
    default: break;
    }
    const bool printed = key > key_space && key < 127 && (key < 'a' || key > 'z');
    return printed ? std::string(1, static_cast<char>(key)) : std::string();
}

bool chord_pressed(const Chord& chord, bool again = false)
{
    const ImGuiIO& io = ImGui::GetIO();
    return chord.key > 0 && io.KeyCtrl == chord.ctrl && io.KeyShift == chord.shift &&
           io.KeyAlt == chord.alt && ImGui::IsKeyPressed(chord.key, again);
}

bool take(std::string_view& text, std::string_view word)
{
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

} // namespace

std::vector<std::string> caps_of(const Chord& chord)
{
    std::vector<std::string> caps;
    if (chord.ctrl) caps.emplace_back("Ctrl");
    if (chord.alt) caps.emplace_back("Alt");
    if (chord.shift) caps.emplace_back("Shift");
    caps.push_back(name_of(chord.key));
    return caps;
}

std::string text_of(const Chord& chord)
{
    std::string text;
    for (const std::string& cap : caps_of(chord)) text += (text.empty() ? "" : "+") + cap;
    return text;
}

std::optional<Chord> chord_from(std::string_view text)
{
    Chord chord;
    chord.ctrl = take(text, "Ctrl+");
    chord.alt = take(text, "Alt+");
    chord.shift = take(text, "Shift+");
    for (chord.key = 1; chord.key < key_count; ++chord.key)
        if (!text.empty() && name_of(chord.key) == text) return chord;
    return std::nullopt;
}

std::optional<Chord> struck_chord()
{
    const ImGuiIO& io = ImGui::GetIO();
    Chord chord{.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
    for (chord.key = 1; chord.key < key_count; ++chord.key)
        if (!name_of(chord.key).empty() && struck(chord)) return chord;
    return std::nullopt;
}

bool is_down(int key)
{
    return ImGui::IsKeyDown(key);
}

void swallow_keys()
{
    for (float& held_s : ImGui::GetIO().KeysDownDuration)
        if (held_s == 0) held_s = 1e-6f;
}

bool struck(const Chord& chord, bool again)
{
    return !ImGui::GetIO().WantTextInput && chord_pressed(chord, again);
}

bool struck_while_typing(const Chord& chord)
{
    return (chord.ctrl || chord.alt || chord.key >= key_escape) && chord_pressed(chord);
}

} // namespace trivar::ui
