// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/number_words.h"
#include "core/document/parameters.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/value_field.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

#include <algorithm>

namespace trivar {
namespace {

// Sizes that a primitive was made with and numbers of steps of shaping: no command sets them, keys
// do. Those of each point of a gesture are left out.
bool only_by_keys(const Object& object, const Parameter& number)
{
    const std::string& name = number.name;
    if (name.starts_with("shape."))
        return !std::holds_alternative<TextShape>(object.source) &&
               !std::holds_alternative<ImportedFile>(object.source);
    const bool step = name.find(".press.") != name.npos || name.find(".shift.") != name.npos;
    return name.starts_with("shaping.") && step && name.find(".samples.") == name.npos &&
           name.find(".points.") == name.npos;
}

Command with_key_of(const Document& document, Id id, const Parameter& number, double frame)
{
    const Track* had = track_of(document, id, number.name);
    return Animate{{{id, {with_key(had ? *had : Track{number.name, {}}, frame, number.value)}}}};
}

} // namespace

void draw_other_numbers(Editor& editor, const ui::Theme& theme, Id id)
{
    constexpr std::size_t most = 60; // rows
    if (!ui::section(theme, "More with keys", false)) return;
    const Document& document = editor.session.document();
    const Ref<Object> each = document.objects.at(id); // edits replace it while we read
    const KeyGutter keys(editor, {id});
    ui::Row row = ui::label_row(theme, "Hidden", false, "so that it can come and go");
    keys.mark(theme, row, {"hidden"});
    bool hidden = each->hidden;
    const ui::Edit eye = ui::check_box(theme, "hidden", hidden, "not in the picture");
    if (eye == ui::Edit::changed)
        editor.session.run(hidden ? Command(Hide{{id}}) : Command(Show{{id}}));
    std::vector<Parameter> numbers = parameters(*each);
    std::erase_if(numbers, [&](const Parameter& one) { return !only_by_keys(*each, one); });
    if (numbers.size() > most) numbers.resize(most);
    for (Parameter& number : numbers) {
        const NumberWords words = words_of_number(number.name);
        row = ui::label_row(theme, words.label, false, "A change of it is a key in this frame.");
        keys.mark(theme, row, {number.name});
        constexpr double endless = 1e9;
        const ui::NumberStyle style{.lo = std::max(number.lo, -endless),
                                    .hi = std::min(number.hi, endless),
                                    .unit = words.unit};
        const ui::Edit edit = value_field(theme, number, style, row.width);
        propose_edit(editor, edit,
                     [&] { return with_key_of(document, id, number, editor.session.frame()); });
        if (edit != ui::Edit::none) break; // the object is another one now
    }
    ui::gap(theme, 8);
}

void draw_kept_view(Editor& editor, const ui::Theme& theme)
{
    const auto& kept_views = editor.session.document().kept_views;
    const auto kept = kept_views.find("picture");
    if (kept == kept_views.end() || !ui::section(theme, "View of pictures")) return;
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
