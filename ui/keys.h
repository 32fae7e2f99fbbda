// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar::ui {

// Key codes: a printable key is its capital letter in ASCII, the others are as GLFW numbers them.
enum Key : int {
    key_space = 32,
    key_plus = 43,
    key_comma = 44,
    key_minus = 45,
    key_period = 46,
    key_slash = 47,
    key_0 = 48,
    key_1 = 49,
    key_equal = 61,
    key_a = 65,
    key_escape = 256,
    key_enter = 257,
    key_tab = 258,
    key_backspace = 259,
    key_insert = 260,
    key_delete = 261,
    key_right = 262,
    key_left = 263,
    key_down = 264,
    key_up = 265,
    key_page_up = 266,
    key_page_down = 267,
    key_home = 268,
    key_end = 269,
    key_f1 = 290,
    key_keypad_0 = 320,
    key_keypad_divide = 331,
    key_keypad_minus = 333,
    key_keypad_plus = 334,
    key_keypad_enter = 335,
    key_left_shift = 340,
    key_left_control = 341,
    key_left_alt = 342,
    key_left_super = 343,
    key_right_shift = 344,
    key_right_super = 347,
    key_count = 349
};

// A Chord is a key with the modifiers that are held with it.
struct Chord {
    int key = 0;
    bool ctrl = false, shift = false, alt = false;
    bool operator==(const Chord&) const = default;
};

// The text of a chord as people write it: "Ctrl+Shift+S", "Esc", "F10"; and the words on each of
// its keys.
std::string text_of(const Chord& chord);
std::vector<std::string> caps_of(const Chord& chord);
std::optional<Chord> chord_from(std::string_view text); // the inverse of text_of

// Whether the chord was struck in this frame and nobody types text; with `again` also while it is
// held, as letters are repeated.
bool struck(const Chord& chord, bool again = false);
// The same while somebody types, for chords that are no letters.
bool struck_while_typing(const Chord& chord);
bool is_down(int key);
// Hides the keys of this frame from everybody who asks later in the frame.
void swallow_keys();
// The chord that was struck in this frame: a key that is no modifier.
std::optional<Chord> struck_chord();

} // namespace trivar::ui
