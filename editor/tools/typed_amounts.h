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

private:
    std::array<std::string, 3> texts_;
    int at_ = 0;
};

} // namespace trivar
