// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/field_rows.h"

namespace trivar {
namespace {

// The texts of a list "one|two|three".
std::vector<std::string> texts_of(std::string_view choices)
{
    std::vector<std::string> out;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('|'), choices.size());
        out.emplace_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return out;
}

} // namespace

ui::NumberStyle number_style(const Rule& rule, bool mixed, std::string_view zero)
{
    constexpr double most_of_a_bar = 160;
    const double factor = shown_factor(rule.unit);
    const double hi = rule.works_to[0] > 0 ? rule.works_to[0] : rule.hi;
    ui::NumberStyle style{.lo = rule.lo * factor, .hi = hi * factor};
    // A factor goes from 1, and not through a range.
    const bool factor_of = rule.unit == Unit::times;
    if (factor_of) style.usual = 1;
    const bool bar = !factor_of && rule.lo >= 0 && style.hi <= most_of_a_bar;
    if (bar) style.bar_hi = style.hi;
    const bool angle = rule.unit == Unit::degrees || rule.unit == Unit::radians;
    if (!bar && angle) style.step = 1;
    if (!bar && rule.unit == Unit::none && rule.lo < 0 && hi <= 100) style.step = 0.01;
    style.unit = rule.unit == Unit::at_frame ? "frame" : unit_text(rule.unit);
    style.zero = zero.empty() ? std::string(rule.zero) : std::string(zero);
    if (mixed) style.words = "mixed";
    return style;
}

void text_choice(ValueRows& rows, const std::string& label, std::string& value,
                 const std::string& rest, const Rule& rule, const RowWords& words)
{
    const std::vector<std::string> texts = texts_of(rule.choices);
    std::vector<std::string> names;
    for (const std::string& text : texts) names.push_back(in_words(text));
    const auto at = [&](const std::string& text) {
        const auto found = std::ranges::find(texts, text);
        return found == texts.end() ? 0 : static_cast<int>(found - texts.begin());
    };
    rows.choice(label, at(value), at(rest), names, words, [&](int chosen) {
        if (chosen != at(value)) value = texts[static_cast<std::size_t>(chosen)];
    });
}

} // namespace trivar
