// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/view.h"
#include "core/commands/words/number_words.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/number_rows.h"
#include "editor/panels/inspector/value_field.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

#include <algorithm>
#include <imgui.h>
#include <optional>

namespace trivar {
namespace {

Command with_key_of(const Document& document, Id id, const Parameter& number, double frame)
{
    const Track* had = track_of(document, id, number.name);
    return Animate{{{id, {with_key(had ? *had : Track{number.name, {}}, frame, number.value)}}}};
}

// Draws a line that names a step over its rows, so that these need not.
void step_caption(const ui::Theme& theme, const std::string& words)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    ui::name_text(
        theme.font.strong,
        ui::rect_at({ImGui::GetWindowPos().x + theme.size.padding, at.y}, {width, theme.size.row}),
        theme.color.text, words);
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({1, theme.size.row});
}

} // namespace

void draw_other_numbers(Editor& editor, const ui::Theme& theme, Id id)
{
    constexpr std::size_t most = 60; // rows
    if (!ui::section(theme, number_rows_title, false)) return;
    const Document& document = editor.session.document();
    const Ref<Object> each = document.objects.at(id); // edits replace it while we read
    const KeyGutter keys(editor, {id});
    ui::Row row =
        ui::label_row(theme, "Hidden", false, "give it keys to show the object only for some time");
    keys.mark(theme, row, {"hidden"});
    bool hidden = each->hidden;
    const ui::Edit eye = ui::check_box(theme, "hidden", hidden, "not in the picture");
    if (eye == ui::Edit::changed)
        editor.session.run(hidden ? Command(Hide{{id}}) : Command(Show{{id}}));
    std::optional<Parameter> taken; // is proposed when all rows are drawn: fewer would scroll
    ui::Edit edit = ui::Edit::none;
    for (const NumberRow& each_row : number_rows(*each, most)) {
        if (!each_row.caption.empty()) step_caption(theme, each_row.caption);
        Parameter number = each_row.number;
        const NumberWords words = words_of_number(number.name);
        row = ui::label_row(theme, each_row.label, false, "A change sets a key in this frame.");
        keys.mark(theme, row, {number.name});
        constexpr double endless = 1e9;
        const ui::NumberStyle style{.lo = std::max(number.lo * words.factor, -endless),
                                    .hi = std::min(number.hi * words.factor, endless),
                                    .unit = words.unit};
        number.value *= words.factor;
        const ui::Edit one = value_field(theme, number, style, row.width);
        if (one == ui::Edit::none) continue;
        edit = one;
        taken = number;
        taken->value /= words.factor;
    }
    propose_edit(editor, edit,
                 [&] { return with_key_of(document, id, *taken, editor.session.frame()); });
    ui::gap(theme, 8);
}

void draw_kept_view(Editor& editor, const ui::Theme& theme)
{
    const auto& kept_views = editor.session.document().kept_views;
    const auto kept = kept_views.find("picture");
    if (kept == kept_views.end() || !ui::section(theme, "Render camera")) return;
    Camera camera = kept->second;
    const KeyGutter keys(editor, {0});
    ValueRows rows{theme, &keys};
    FieldRows<Camera> fields(rows, camera, "camera.picture");
    fields.resting_at(camera.eye, &Camera::eye);
    fields.resting_at(camera.target, &Camera::target);
    if (camera.perspective) fields.resting_at(camera.fov_y, &Camera::fov_y);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return KeepView{"picture", camera}; });
}

} // namespace trivar
