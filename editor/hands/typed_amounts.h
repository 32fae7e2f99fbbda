// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expression.h"

#include <array>
#include <optional>
#include <string>

namespace trivar {

// TypedAmounts are up to three numbers that are typed while a gesture runs: "1.25", then Tab and
// the next. Any digit, minus, point or "=" begins one. Letters that the gesture itself uses (x, y,
// z) are taken only after "=".
class TypedAmounts {
public:
    bool open() const; // something was typed
    bool take(char c); // whether the character belongs to the number
    void erase_last();
    void next(int count) { at_ = (at_ + 1) % count; }
    void begin_anew(); // the axes have changed; the number that was being typed is the first
    int at() const { return at_; }
    const std::string& text(int i) const { return texts_[static_cast<std::size_t>(i)]; }
    // The last value of a number that could be read; empty where there was none.
    std::optional<double> value(int i, Measure measure) const;
    // The number for a status line: the typed text with a mark where the next letter goes, and its
    // value; where nothing is typed, `said`, for example "1.25 m".
    std::string words(int i, const std::string& unit, const std::string& said) const;
    // Takes the letters of this frame; returns whether there were any.
    bool take_letters();

private:
    std::array<std::string, 3> texts_;
    int at_ = 0;
};

} // namespace trivar
