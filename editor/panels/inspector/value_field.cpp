// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/value_field.h"

#include "core/commands/words/number_words.h"
#include "editor/words/field_words.h"

#include <cmath>

namespace trivar {

ui::Edit value_field(const ui::Theme& theme, Parameter& number, const ui::NumberStyle& style,
                     float width)
{
    using Kind = Parameter::Kind;
    const auto whole = [&](auto&& draw) {
        int value = static_cast<int>(std::lround(number.value));
        const ui::Edit edit = draw(value);
        number.value = value;
        return edit;
    };
    if (number.kind == Kind::on_off) {
        bool on = number.value >= 0.5;
        const ui::Edit edit = ui::check_box(theme, number.name, on, "on");
        number.value = on ? 1 : 0;
        return edit;
    }
    if (number.kind == Kind::choice) {
        std::vector<std::string> names;
        for (const std::string_view name : number.choices) names.push_back(in_words(name));
        return whole([&](int& v) { return ui::choice(theme, number.name, v, names, width); });
    }
    if (number.kind == Kind::whole)
        return whole(
            [&](int& v) { return ui::integer_field(theme, number.name, v, style, width); });
    return ui::number_field(theme, number.name, number.value, style, width);
}

} // namespace trivar
