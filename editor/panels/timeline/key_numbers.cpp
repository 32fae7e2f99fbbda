// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/number_words.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/value_field.h"
#include "editor/panels/timeline/timeline.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <map>

namespace trivar {
namespace {

// A CommonNumber holds what the chosen keys have in common.
struct CommonNumber {
    const Key* first = nullptr;
    const Track* track = nullptr;
    NumberWords words;
    Parameter number; // whose the first one's value is
    bool values = true, tweens = true, repeats = true;
    bool stay = true; // none of them has a way to the next
};
CommonNumber common(const Document& document, const ChosenKeys& keys)
{
    CommonNumber out;
    std::map<Id, std::vector<Parameter>> known;
    for (const KeyName& name : keys) {
        const Key* key = key_of(document, name);
        if (!key) continue;
        const Track* track = track_of(document, name.track);
        const NumberWords words = words_of_number(name.track.parameter);
        const auto [of, is_new] = known.try_emplace(name.track.id);
        if (is_new)
            of->second = name.track.id == 0 ? scene_parameters(document)
                                            : parameters(object(document, name.track.id));
        const auto number = std::ranges::find(of->second, name.track.parameter, &Parameter::name);
        const Parameter own =
            number == of->second.end() ? Parameter{name.track.parameter} : *number;
        out.stay = out.stay && own.stays();
        if (!out.first) {
            out.number = own;
            out.first = key;
            out.track = track;
            out.words = words;
        }
        out.values =
            out.values && key->value == out.first->value && words.factor == out.words.factor;
        out.tweens = out.tweens && key->tween == out.first->tween;
        out.repeats = out.repeats && track->repeat == out.track->repeat;
        if (words.unit != out.words.unit) out.words.unit.clear();
        if (own.kind != out.number.kind || own.choices != out.number.choices)
            out.number.kind = Parameter::Kind::number;
    }
    return out;
}

double first_frame(const ChosenKeys& keys)
{
    double first = keys.begin()->frame;
    for (const KeyName& key : keys) first = std::min(first, key.frame);
    return first;
}

} // namespace

void draw_key_numbers(Editor& editor, const ui::Theme& theme, const ui::Rect& place)
{
    KeysView& view = editor.timeline.keys;
    const CommonNumber now = common(editor.session.document(), view.chosen);
    if (!now.first) return;
    // A field that is dragged changes the keys that were there when it began.
    if (!editor.inspecting) view.typed = view.chosen;
    const Document& document = editor.session.committed();
    const ChosenKeys chosen = view.typed;
    constexpr float frame_width = 68, value_width = 88, way_width = 196, after_width = 124,
                    between = 4;
    float room = place.width() / theme.scale - frame_width - value_width - between;
    const bool has_way = room >= way_width + between && !now.stay;
    if (has_way) room -= way_width + between;
    const bool has_after = room >= after_width + between;
    float x = place.hi.x - theme.px(8);
    const auto next = [&](float width) {
        x -= theme.px(width);
        ImGui::SetCursorScreenPos({x, std::round(place.center().y - theme.size.row / 2)});
        x -= theme.px(between);
        return theme.px(width);
    };
    KeyEdit edit;
    ui::Edit how = ui::Edit::none;
    const auto take = [&](ui::Edit one, auto&& change) {
        if (one == ui::Edit::none) return;
        how = one;
        if (one == ui::Edit::changed) edit = change();
    };
    ImGui::PushID("key numbers");
    if (has_after) {
        int after = now.repeats ? static_cast<int>(now.track->repeat) : -1;
        const float width = next(after_width);
        take(ui::choice(theme, "after", after, {"Then stays", "Then loops", "Back and forth"},
                        width),
             [&] { return with_repeat(document, chosen, static_cast<Repeat>(after)); });
    }
    if (has_way) {
        int way = now.tweens ? static_cast<int>(now.first->tween) : -1;
        const float width = next(way_width);
        take(ui::segments(theme, "way", way, {"Step", "Linear", "Cubic", "Settle"}, width),
             [&] { return with_tween(document, chosen, static_cast<Tween>(way)); });
        ui::tooltip(
            {"To the next key",
             {},
             "Step holds the value, Linear is a straight line, Cubic follows draggable handles, "
             "Settle swings past it and back."});
    }
    Parameter value = now.number;
    value.name = "value";
    value.value = now.first->value * now.words.factor;
    ui::NumberStyle style{.unit = now.words.unit};
    if (!now.values) style.words = "mixed";
    const float value_px = next(value_width);
    const ui::Edit of_value = value_field(theme, value, style, value_px);
    ui::tooltip({"Value of the selected keys", {}, now.words.label});
    take(of_value, [&] { return with_value(document, chosen, value.value / now.words.factor); });
    double frame = first_frame(view.chosen);
    ui::NumberStyle frames{.lo = -1e6, .hi = 1e6, .step = 1, .axis = "F"};
    const double before = first_frame(chosen);
    const float frame_px = next(frame_width);
    const ui::Edit of_frame = ui::number_field(theme, "frame", frame, frames, frame_px);
    ui::tooltip({"Frame of the selected keys",
                 {},
                 "With several keys this is the first; the others move with it."});
    take(of_frame, [&] { return moved(document, chosen, frame - before); });
    ImGui::PopID();
    if (how == ui::Edit::changed && !edit.command) return;
    if (how == ui::Edit::none || editor.session.committing()) return;
    if (how == ui::Edit::changed) {
        if (!editor.session.propose(*edit.command)) return;
        editor.inspecting = true;
        view.chosen = edit.keys;
    } else if (how == ui::Edit::cancelled) {
        editor.session.cancel();
        editor.inspecting = false;
        view.chosen = present_keys(editor.session.document(), chosen);
    }
}

} // namespace trivar
