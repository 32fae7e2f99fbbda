// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/inspector/key_gutter.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trivar {

// ValueRows are rows that change one value each and remember whether any did.
struct ValueRows {
    const ui::Theme& theme;
    const KeyGutter* keys = nullptr; // null: no row has a mark
    ui::Edit edit = ui::Edit::none;
    double stop = 1e300; // at which drags of the next number halt for a while, as it is shown

    void take(ui::Edit one)
    {
        if (one != ui::Edit::none) edit = one;
    }
    // Draws the row's field, unless its dot was pressed, which resets the value. `apart`: each of
    // the numbers has a field of its own.
    template <class T, class Field>
    void row(const std::string& label, T& value, const T& rest, const RowWords& words,
             Field&& field, bool apart = false)
    {
        const ui::Row at = ui::label_row(theme, label, value != rest, words.help);
        if (keys && !words.parameters.empty()) keys->mark(theme, at, words.parameters, apart);
        if (at.reset) {
            field(at.width); // the row keeps its place
            value = rest;
            take(ui::Edit::changed);
            return;
        }
        take(field(at.width));
    }
    void number(const std::string& label, double& value, double rest, const ui::NumberStyle& style,
                const RowWords& words)
    {
        ui::NumberStyle halting = style;
        halting.stop = std::min(std::exchange(stop, 1e300), 1e300);
        row(label, value, rest, words,
            [&](float width) { return ui::number_field(theme, label, value, halting, width); });
    }
    // Draws a length that is `present` where it is 0: a drag from "auto" begins at that.
    void size(const std::string& label, double& value, double present, const RowWords& words)
    {
        const std::string zero = present > 0 ? "auto, " + ui::short_number(present) : "auto";
        const ui::NumberStyle style{
            .lo = 0, .hi = 1e6, .unit = "m", .zero = zero, .words = value == 0 ? zero : ""};
        row(label, value, 0.0, words, [&](float width) {
            double shown = value > 0 ? value : present;
            const ui::Edit one = ui::number_field(theme, label, shown, style, width);
            if (one == ui::Edit::changed) value = shown;
            return one;
        });
    }
    void integer(const std::string& label, int& value, int rest, const ui::NumberStyle& style,
                 const RowWords& words)
    {
        row(label, value, rest, words,
            [&](float width) { return ui::integer_field(theme, label, value, style, width); });
    }
    void check(const std::string& label, bool& value, bool rest, const std::string& effect,
               const RowWords& words)
    {
        row(label, value, rest, words,
            [&](float) { return ui::check_box(theme, label, value, effect); });
    }
    void choice(const std::string& label, int value, int rest,
                const std::vector<std::string>& names, const RowWords& words, auto&& use)
    {
        row(label, value, rest, words,
            [&](float width) { return ui::segments(theme, label, value, names, width); });
        use(value);
    }
    using Names = std::array<std::string, 3>;
    void triple(const std::string& label, glm::ivec3& value, const glm::ivec3& rest,
                const ui::NumberStyle& style, const RowWords& words,
                const Names& names = {"U", "V", "W"});
};

} // namespace trivar
