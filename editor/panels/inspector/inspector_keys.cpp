// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/number_words.h"
#include "core/document/parameters.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/value_field.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"
#include "editor/words/volume_words.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

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
    const bool step = name.find(".press.") != name.npos || name.find(".shift.") != name.npos ||
                      name.find(".warp.") != name.npos;
    return name.starts_with("shaping.") && step && name.find(".samples.") == name.npos &&
           name.find(".points.") == name.npos;
}

Command with_key_of(const Document& document, Id id, const Parameter& number, double frame)
{
    const Track* had = track_of(document, id, number.name);
    return Animate{{{id, {with_key(had ? *had : Track{number.name, {}}, frame, number.value)}}}};
}

// Of "shaping.2.shift.by.x": "shaping.2.shift", which all numbers of that step begin with; empty:
// it is of no step.
std::string step_of(const std::string& parameter)
{
    std::size_t end = parameter.starts_with("shaping.") ? 0 : parameter.npos;
    for (int part = 0; part < 3 && end != parameter.npos; ++part)
        end = parameter.find('.', end + 1);
    return end == parameter.npos ? "" : parameter.substr(0, end);
}

// A line over the rows of a step that says what it was, so that they need not.
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

std::string caption_of(const Object& object, const std::string& step)
{
    const std::size_t number = std::stoul(step.substr(step.find('.') + 1));
    const bool box = std::holds_alternative<LatticeShape>(object.source);
    return fmt::format("Step {}: {}", number + 1, words_of(*object.shaping[number], box));
}

// What differs among the numbers of one step: "Move X" of "Step 1 shift move X".
std::string label_in(const std::string& step, const std::string& label)
{
    std::string own = step.empty() ? label : label.substr(words_of_number(step).label.size() + 1);
    own[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(own[0])));
    return own;
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
    std::string step;
    std::optional<Parameter> taken; // is proposed when all rows are drawn: fewer would scroll
    ui::Edit edit = ui::Edit::none;
    for (Parameter& number : numbers) {
        const NumberWords words = words_of_number(number.name);
        const std::string before = std::exchange(step, step_of(number.name));
        if (!step.empty() && step != before) step_caption(theme, caption_of(*each, step));
        row = ui::label_row(theme, label_in(step, words.label), false,
                            "A change of it is a key in this frame.");
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
