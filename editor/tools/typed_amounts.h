// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expression.h"

#include <array>
#include <optional>
#include <string>

namespace trivar {

// Up to three numbers that are typed while a gesture goes on: "1.25", then Tab and the next. Any
// digit, minus, point or "=" begins one. Letters that the gesture wants for itself (x, y, z) are
// taken only after "=".
class TypedAmounts {
public:
    bool open() const; // something was typed
    bool take(char c); // whether it belongs to the number
    void erase_last();
    void next(int count) { at_ = (at_ + 1) % count; }
    void begin_anew(); // other axes are meant now; the number that was being typed is the first
    int at() const { return at_; }
    const std::string& text(int i) const { return texts_[static_cast<std::size_t>(i)]; }
    // The last value of a number that could be read; nothing where nothing was.
    std::optional<double> value(int i, Measure measure) const;
    // As a status line shows it: what is typed as it is typed, with a mark where the next letter
    // goes, and what it comes to, which is `said`, "1.25 m", where nothing is typed.
    std::string words(int i, const std::string& unit, const std::string& said) const;
    // The letters that were typed in this frame; whether there were any.
    bool take_letters();

private:
    std::array<std::string, 3> texts_;
    int at_ = 0;
};

} // namespace trivar
