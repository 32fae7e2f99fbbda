// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/number_words.h"
#include "editor/panels/timeline/key_hands.h"
#include "editor/panels/timeline/timeline.h"
#include "editor/timeline/rows.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

using RowKind = TimelineRow::Kind;

// A click on a name: the object, and of a row of its own the track with all its keys.
void choose_row(Editor& editor, const TimelineRow& row)
{
    KeysView& view = editor.timeline.keys;
    Session& session = editor.session;
    const bool adds = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
    if (row.id != 0 && adds && row.kind == RowKind::object)
        session.selected.toggle(row.id);
    else if (row.id != 0 && !session.selected.contains(row.id))
        session.selected = row.id;
    if (row.kind != RowKind::track) {
        if (!adds) view.tracks.clear();
        return;
    }
    const bool was = view.tracks.contains(row.track());
    if (!adds) view.tracks.clear();
    if (adds && was)
        view.tracks.erase(row.track());
    else
        view.tracks.insert(row.track());
}

// The present value, with which a row of a track ends; nothing where there is no such number.
std::string value_of_row(const Document& document, const TimelineRow& row,
                         const NumbersOfTracks& numbers, double frame)
{
    const Track* track = track_of(document, row.track());
    const auto number = numbers.find(row.track());
    if (!track || number == numbers.end()) return {};
    return words_of_value(number->second, value_at(*track, frame));
}

void paint_row_keys(const ui::Theme& theme, const ui::Rect& row, const FrameScale& scale,
                    const KeysView& view, const Document& document, const TimelineRow& of,
                    const KeySpot* hot)
{
    const ui::Palette& c = theme.color;
    const bool whole = of.kind == RowKind::object;
    const std::vector<KeysAt> keys = keys_of_row(document, of);
    const float y = std::round(row.center().y), half = theme.px(whole ? 2 : 3);
    const auto value = [&](const KeysAt& at) { return key_of(document, at.keys.front())->value; };
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const bool rests = !whole && value(keys[i]) == value(keys[i + 1]);
        const float from = std::max(scale.x(keys[i].frame), row.lo.x),
                    to = std::min(scale.x(keys[i + 1].frame), row.hi.x);
        const float thick = rests ? theme.px(1) : half;
        if (to > from) ui::paint_box({{from, y - thick}, {to, y + thick}}, c.field_hover, thick);
    }
    for (const KeysAt& at : keys) {
        const glm::vec2 p{scale.x(at.frame), y};
        if (p.x < row.lo.x - theme.px(8) || p.x > row.hi.x + theme.px(8)) continue;
        const bool chosen = is_chosen(view, at.keys);
        const bool some = std::ranges::any_of(
            at.keys, [&](const KeyName& key) { return view.chosen.contains(key); });
        const bool under = hot && hot->at == p;
        const float radius = theme.px(whole ? 5 : 6) + (under ? theme.px(1) : 0) + 0.5f;
        ui::paint_diamond(p, radius, chosen ? c.key : c.base,
                          some ? c.key : ui::faded(c.key, 0.85f), theme.size.hairline * 1.5f);
        if (chosen) ui::paint_diamond(p, radius, 0, c.text, theme.size.hairline);
    }
}

void draw_row_name(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
                   const TimelineRow& of, bool folds, const NumbersOfTracks& numbers)
{
    const ui::Palette& c = theme.color;
    Session& session = editor.session;
    KeysView& view = editor.timeline.keys;
    const Document& document = session.document();
    const bool whole = of.kind == RowKind::object;
    const bool lost = of.kind == RowKind::track && !numbers.contains(of.track());
    const bool can_open = folds && whole && !tracks_of(document, of.id).empty();
    const float indent = whole ? 0 : theme.px(16);
    if (can_open) {
        ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
        if (ImGui::InvisibleButton("open", {theme.px(24), row.height()}))
            if (view.unfolded.erase(of.id) == 0) view.unfolded.insert(of.id);
    }
    const float left = row.lo.x + (can_open ? theme.px(24) : 0);
    ImGui::SetCursorScreenPos({left, row.lo.y});
    if (ImGui::InvisibleButton("name", {row.hi.x - left, row.height()})) choose_row(editor, of);
    const bool hovered = ImGui::IsItemHovered();
    if (whole && hovered && can_open && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        if (view.unfolded.erase(of.id) == 0) view.unfolded.insert(of.id);
    const bool selected = of.kind == RowKind::track
                              ? view.tracks.contains(of.track())
                              : of.id != 0 && session.selected.contains(of.id);
    if (selected)
        ui::paint_box(row,
                      whole || of.kind == RowKind::travel ? c.row_selected : c.row_selected_idle);
    else if (hovered)
        ui::paint_box(row, c.row_hover);
    const bool dim = whole && of.id != 0 && !visible(document, of.id);
    ui::Rect in = {row.lo + glm::vec2(theme.px(24) + indent, 0),
                   row.hi - glm::vec2(theme.px(14), 0)};
    if (can_open)
        ui::paint_text(theme.font.body, {row.lo + glm::vec2(theme.px(10), 0), row.hi}, c.text_2,
                       view.unfolded.contains(of.id) ? ui::icon::open : ui::icon::closed);
    const std::string note =
        of.kind == RowKind::track ? value_of_row(document, of, numbers, session.frame())
        : of.travels              ? ui::short_number(object(document, of.id).travel.speed) + " m/s"
                                  : std::string();
    const float room = in.width() - ui::text_width(theme.font.small, note) - theme.px(8);
    const std::string name = name_of_row(document, of);
    ui::paint_text(whole ? theme.font.body : theme.font.small, in,
                   dim || lost ? c.text_off
                   : whole     ? c.text
                               : c.text_2,
                   ui::elided(whole ? theme.font.body : theme.font.small, name, room));
    ui::paint_text(theme.font.small, in, c.text_2, note, ui::Align::right);
    ui::tooltip({name,
                 {},
                 lost                        ? "This property no longer exists; its keys are kept."
                 : of.kind == RowKind::track ? "In the log: " + of.parameter
                                             : std::string()});
}

} // namespace

float draw_row_names(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                     const std::vector<TimelineRow>& rows, float y, bool folds)
{
    const float height = theme.size.row;
    const NumbersOfTracks numbers = numbers_of(editor.session.document(), rows);
    for (const TimelineRow& row : rows) {
        ImGui::PushID(row.id);
        ImGui::PushID(static_cast<int>(row.kind));
        ImGui::PushID(row.parameter.c_str());
        ui::paint_box({{names.lo.x, y + height - theme.size.hairline}, {names.hi.x, y + height}},
                      theme.color.line_soft);
        draw_row_name(editor, theme, {{names.lo.x, y}, {names.hi.x, y + height}}, row, folds,
                      numbers);
        ImGui::PopID();
        ImGui::PopID();
        ImGui::PopID();
        y += height;
    }
    return y;
}

void draw_key_rows(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                   const ui::Rect& tracks, const FrameScale& scale)
{
    const ui::Palette& c = theme.color;
    Session& session = editor.session;
    KeysView& view = editor.timeline.keys;
    ImGui::SetCursorScreenPos({names.lo.x, names.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("tracks", {tracks.hi.x - names.lo.x, tracks.height()});
    const float height = theme.size.row, first = ImGui::GetCursorScreenPos().y;
    const std::vector<TimelineRow> rows =
        timeline_rows(session.document(), view.unfolded); // edits replace it
    const float end = first + height * static_cast<float>(rows.size());
    ui::lower_area("keys", {{tracks.lo.x, first}, {tracks.hi.x, std::max(end, tracks.hi.y)}});
    KeyField field;
    field.hovered = ImGui::IsItemHovered();
    field.active = ImGui::IsItemActive();
    field.activated = ImGui::IsItemActivated();
    field.reach_px = theme.px(9);
    field.meant = [&](glm::vec2 p) { return glm::dvec2(scale.frame_at(p.x), 0); };
    const auto place = [&](std::size_t i) {
        const float y = first + height * static_cast<float>(i);
        return ui::Rect{{tracks.lo.x, y}, {tracks.hi.x, y + height}};
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (KeysAt& at : keys_of_row(session.document(), rows[i]))
            field.spots.push_back(
                {{scale.x(at.frame), std::round(place(i).center().y)}, std::move(at.keys)});
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const KeySpot* hot = field.hovered ? spot_at(field, {mouse.x, mouse.y}) : nullptr;
    draw_row_names(editor, theme, names, rows, first, true);
    ImGui::PushClipRect({tracks.lo.x, tracks.lo.y}, {tracks.hi.x, tracks.hi.y}, true);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ui::Rect row = place(i);
        ui::paint_box({{row.lo.x, row.hi.y - theme.size.hairline}, row.hi}, c.line_soft);
        ImGui::PushID(rows[i].id);
        const bool with_keys =
            rows[i].kind == RowKind::object && !tracks_of(session.document(), rows[i].id).empty();
        if (rows[i].travels) draw_travel_bar(editor, theme, row, scale, rows[i].id, !with_keys);
        ImGui::PopID();
        paint_row_keys(theme, row, scale, view, session.document(), rows[i], hot);
    }
    const float now = std::round(scale.x(session.frame()));
    if (now >= tracks.lo.x)
        ui::paint_line({now, tracks.lo.y}, {now, tracks.hi.y}, c.focus, 1.5f * theme.scale);
    use_keys(editor, theme, field);
    paint_key_box(theme, view);
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({names.lo.x, end});
    ImGui::Dummy({1, 1});
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) let_go_of_bar(editor);
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
}

} // namespace trivar
