// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/ink_rows.h"

#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/srgb_field.h"

namespace trivar {

void draw_ink_rows(ValueRows& rows, LineStyle& ink, const LineStyle& rest,
                   const std::string& parameter)
{
    const ui::Theme& theme = rows.theme;
    FieldRows<LineStyle> fields(rows, ink, parameter);
    using S = LineStyle;
    // Lengths as drawings have them, though larger ones can be typed.
    const auto length = [&](float S::*member, double usual) {
        double shown = static_cast<double>(ink.*member);
        const Rule rule = facts_of(member).rule;
        ui::NumberStyle style = number_style(rule, false, {});
        style.bar_hi = -1e300;
        style.usual = usual;
        rows.number(FieldRows<S>::label(member), shown, static_cast<double>(rest.*member), style,
                    fields.words_of(member));
        if (shown != static_cast<double>(ink.*member)) ink.*member = static_cast<float>(shown);
    };
    length(&S::width, 1);
    fields(&S::width_by);
    ui::rows_if(theme, ink.width_by != LineWidth::even, "The width is even.",
                [&] { fields(&S::finest); });
    fields(&S::color_by);
    ui::rows_if(theme, ink.color_by == LineColor::plain, "The colour is not plain.", [&] {
        RowWords words = fields.words_of(&S::color);
        const std::string base = words.parameters.front();
        words.parameters = axes_of(base);
        rows.row(FieldRows<S>::label(&S::color), ink.color, rest.color, words,
                 [&](float width) { return srgb_field(theme, "color", ink.color, width); });
    });
    fields(&S::hidden);
    length(&S::taper, 4);
    length(&S::wobble, 1);
    fields(&S::pencil);
    ui::rows_if(theme, ink.wobble > 0 || ink.pencil > 0, "Lines neither wobble nor are in pencil.",
                [&] { fields(&S::seed); });
    length(&S::fan_step, 10);
    ui::rows_if(theme, ink.fan_step > 0, "There are no fans.", [&] { length(&S::fan_length, 10); });
}

void draw_more_line_rows(ValueRows& rows, MoreLines& more, const std::string& parameter)
{
    FieldRows<MoreLines> fields(rows, more, parameter);
    fields(&MoreLines::suggestive);
    fields(&MoreLines::ridges);
    fields(&MoreLines::valleys);
    fields(&MoreLines::parabolic);
    fields(&MoreLines::isophotes);
    ui::rows_if(rows.theme, more.isophotes > 0, "No isophotes are drawn.",
                [&] { fields(&MoreLines::light); });
    ui::rows_if(rows.theme, more.any(), "None of the lines above is drawn.", [&] {
        fields(&MoreLines::smoothing);
        fields(&MoreLines::detail);
        fields(&MoreLines::width);
    });
    fields(&MoreLines::amount);
}

} // namespace trivar
