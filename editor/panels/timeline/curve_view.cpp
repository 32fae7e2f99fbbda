// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/number_words.h"
#include "editor/panels/timeline/curve_scale.h"
#include "editor/panels/timeline/key_hands.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

// One for each of the curves that are shown: of its axis, where no other has that already.
std::vector<ui::Color> colors_of_curves(const ui::Palette& c, const std::vector<TrackName>& tracks)
{
    const std::array axes{c.letter_x, c.letter_y, c.letter_z};
    const std::array others{c.lattice, c.text_2, c.stroke, c.good};
    std::array<bool, 3> taken{};
    std::size_t next = 0;
    std::vector<ui::Color> out;
    for (const TrackName& track : tracks) {
        const auto axis = std::string_view("xyz").find(track.parameter.back());
        const bool has_axis = axis < 3 && track.parameter[track.parameter.size() - 2] == '.';
        if (has_axis && !std::exchange(taken[axis], true))
            out.push_back(axes[axis]);
        else
            out.push_back(others[next++ % others.size()]);
    }
    return out;
}

// Writes the value with as many decimals as the step has.
std::string tick_text(double value, double step)
{
    if (std::abs(value) < step / 2) value = 0;
    if (step < 1e-6 || step >= 1e6) return ui::short_number(value);
    return fmt::format("{:.{}f}", value,
                       static_cast<int>(std::max(0.0, std::ceil(-std::log10(step) - 1e-9))));
}

// The values of all curves, or of that one, that have a line; these begin where the numbers end.
struct Values {
    ValueTicks ticks;
    std::vector<float> y; // from below
    float left = 0;       // of the lines
};
Values values_in(const ui::Theme& theme, const ui::Rect& r, const CurveScale& scale)
{
    Values out{value_ticks(scale, theme.px(28)), {}, scale.frames.lo - theme.px(10)};
    for (int i = 0; i < 100; ++i) {
        const float y = std::round(scale.y(out.ticks.first + i * out.ticks.step));
        if (y < r.lo.y) break;
        out.y.push_back(y);
    }
    return out;
}

void paint_lines(const ui::Theme& theme, const ui::Rect& r, const Values& values)
{
    for (std::size_t i = 0; i < values.y.size(); ++i) {
        const double value = values.ticks.first + static_cast<double>(i) * values.ticks.step;
        const bool zero = std::abs(value) < values.ticks.step / 2;
        ui::paint_line({values.left, values.y[i]}, {r.hi.x, values.y[i]},
                       zero ? theme.color.text_off : theme.color.line_soft, theme.size.hairline);
    }
}

// Before the first frame, over what else is there; without the unit where there is no room for it.
void paint_numbers(const ui::Theme& theme, const ui::Rect& r, const Values& values,
                   const std::string& unit, ui::Color color)
{
    const float half = theme.px(8), gap = theme.px(4);
    const ui::Rect all = {{r.lo.x + gap, r.lo.y}, {values.left - gap, r.hi.y}};
    const std::string after = unit.empty() ? "" : unit == "deg" ? "°" : " " + unit;
    std::vector<std::string> words;
    float widest = 0;
    for (std::size_t i = 0; i < values.y.size(); ++i) {
        const double value = values.ticks.first + static_cast<double>(i) * values.ticks.step;
        words.push_back(tick_text(value, values.ticks.step));
        widest = std::max(widest, ui::text_width(theme.font.small, words.back() + after));
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
        const float y = values.y[i];
        if (y - half < r.lo.y || y + half > r.hi.y) continue; // it would be cut
        if (widest <= all.width()) words[i] += after;
        const float width = ui::text_width(theme.font.small, words[i]);
        const float left = std::max(all.lo.x, all.hi.x - width);
        const ui::Rect at = {{left, y - half}, {left + width, y + half}};
        ui::paint_box(at.grown(theme.px(2)), theme.color.base, theme.size.rounding_small);
        ui::paint_text(theme.font.small, at, color, words[i]);
    }
}

// At the upper right: whether each curve fills the height.
void draw_alone(Editor& editor, const ui::Theme& theme, const ui::Rect& r, bool alone)
{
    const ui::Palette& c = theme.color;
    const std::string words = "Normalised";
    const glm::vec2 size{ui::text_width(theme.font.body, words) + theme.px(20), theme.px(22)};
    const ui::Rect at = ui::rect_at({r.hi.x - size.x - theme.px(8), r.lo.y + theme.px(6)}, size);
    ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
    const bool clicked = ImGui::InvisibleButton("alone", {size.x, size.y});
    ui::paint_box(at,
                  alone                    ? c.segment
                  : ImGui::IsItemHovered() ? c.field_hover
                                           : c.field,
                  theme.size.rounding_small);
    ui::paint_text(theme.font.body, at, alone ? c.text : c.text_2, words, ui::Align::center);
    ui::tooltip(
        {"Each curve fills the height",
         {},
         "Curves with different units are always shown so. The numbers at the left belong to the "
         "curve of their colour: the one under the pointer, or that of the selected key."});
    if (clicked) editor.timeline.keys.alone = !alone;
}

// Before the names of the tracks whose curves are shown, as these are coloured.
void paint_swatches(const ui::Theme& theme, const ui::Rect& names,
                    const std::vector<TimelineRow>& rows, const std::vector<TrackName>& shown,
                    const std::vector<ui::Color>& colors, float y)
{
    for (const TimelineRow& row : rows) {
        const auto at = std::ranges::find(shown, row.track());
        if (row.kind == TimelineRow::Kind::track && at != shown.end())
            ui::paint_dot({names.lo.x + theme.px(28), y + theme.size.row / 2}, theme.px(4),
                          colors[static_cast<std::size_t>(at - shown.begin())]);
        y += theme.size.row;
    }
}

// Handles of a key that is chosen, where its curve has them.
void add_handles(std::vector<KeySpot>& spots, const Track& track, std::size_t k,
                 const KeyName& name, const CurveScale& scale, double factor)
{
    const auto at = [&](glm::dvec2 p) { return scale.at(p.x, p.y * factor); };
    if (k + 1 < track.keys.size() && track.keys[k].tween == Tween::cubic)
        spots.push_back({at(curve_between(track, k).p1), {name}, KeyHandle::after});
    if (k > 0 && track.keys[k - 1].tween == Tween::cubic)
        spots.push_back({at(curve_between(track, k - 1).p2), {name}, KeyHandle::before});
}

std::vector<KeySpot> spots_of(const Document& document, const KeysView& view,
                              const std::vector<TrackName>& tracks, const CurveScales& scales)
{
    std::vector<KeySpot> handles, keys;
    for (const TrackName& name : tracks) {
        const Track& track = *track_of(document, name);
        const CurveScale scale = scales.of(name);
        const double factor = words_of_number(name.parameter).factor;
        for (std::size_t k = 0; k < track.keys.size(); ++k) {
            const KeyName key{name, track.keys[k].frame};
            if (view.chosen.contains(key)) add_handles(handles, track, k, key, scale, factor);
            keys.push_back({scale.at(key.frame, track.keys[k].value * factor), {key}});
        }
    }
    handles.insert(handles.end(), keys.begin(), keys.end()); // a key lies over its handles
    return handles;
}

void paint_curves(const ui::Theme& theme, const Document& document, const KeysView& view,
                  const std::vector<TrackName>& tracks, const KeyField& field,
                  const CurveScales& scales, const std::vector<ui::Color>& colors,
                  const KeySpot* hot)
{
    const ui::Palette& c = theme.color;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const Track& track = *track_of(document, tracks[i]);
        const CurveScale scale = scales.of(tracks[i]);
        const double factor = words_of_number(tracks[i].parameter).factor;
        const ui::Color color = colors[i];
        const auto& first = track.keys.front();
        ui::paint_line(scale.at(std::min(scale.frames.first, first.frame), first.value * factor),
                       scale.at(first.frame, first.value * factor), ui::faded(color, 0.4f),
                       theme.size.hairline);
        ui::paint_path(curve_path(track, scale, factor, false), ui::faded(color, 0.4f),
                       theme.size.hairline);
        ui::paint_path(curve_path(track, scale, factor, true), color, 1.8f * theme.scale);
    }
    for (const KeySpot& spot : field.spots) {
        const bool under = hot == &spot;
        if (spot.handle) {
            const Key& key = *key_of(document, spot.keys.front());
            const double factor = words_of_number(spot.keys.front().track.parameter).factor;
            const CurveScale scale = scales.of(spot.keys.front().track);
            ui::paint_line(scale.at(key.frame, key.value * factor), spot.at, c.text_3,
                           theme.size.hairline);
            ui::paint_dot(spot.at, theme.px(under ? 5 : 4), c.base, c.text_2, 1.5f * theme.scale);
            continue;
        }
        const bool chosen = is_chosen(view, spot.keys);
        const float radius = theme.px(under ? 6 : 5) + 0.5f;
        ui::paint_diamond(spot.at, radius, chosen ? c.key : c.base, c.key,
                          1.5f * theme.size.hairline);
        if (chosen) ui::paint_diamond(spot.at, radius, 0, c.text, theme.size.hairline);
    }
}

// The wheel zooms about the mouse, the middle button moves what is shown.
void look_round(Editor& editor, const CurveScale& scale, bool hovered, bool panning)
{
    const ImGuiIO& io = ImGui::GetIO();
    const float wheel = io.MouseWheel;
    if (hovered && wheel != 0 && !io.KeyCtrl && !io.KeyShift) {
        editor.timeline.keys.values =
            zoomed_values(scale.values, scale.value_at(io.MousePos.y), static_cast<double>(wheel));
        const glm::dvec2 shown =
            zoomed_frames({scale.frames.first, scale.frames.last}, scale.frames.all,
                          scale.frames.frame_at(io.MousePos.x), static_cast<double>(wheel));
        editor.timeline.shown = kept_frames(shown, scale.frames.time);
    }
    if (!panning || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
    const double up = scale.value_at(0) - scale.value_at(io.MouseDelta.y);
    editor.timeline.keys.values = scale.values + up;
    const double width = scale.frames.last - scale.frames.first;
    const double notches = (scale.frames.frame_at(io.MouseDelta.x) - scale.frames.frame_at(0)) /
                           std::max(1e-9, 0.1 * width);
    if (editor.timeline.shown)
        editor.timeline.shown = rolled_frames(*editor.timeline.shown, scale.frames.all, notches);
}

void fit_chosen(Editor& editor, const FrameScale& frames, const CurveScales& scales)
{
    KeysView& view = editor.timeline.keys;
    if (!std::exchange(view.fit_chosen, false) || view.chosen.empty()) return;
    double first = 1e300, last = -1e300;
    for (const KeyName& key : view.chosen) {
        first = std::min(first, key.frame);
        last = std::max(last, key.frame);
    }
    const double width =
        std::clamp(last - first, 10.0, std::max(10.0, frames.all.y - frames.all.x));
    const double middle = (first + last) / 2;
    editor.timeline.shown = rolled_frames({middle - width / 2, middle + width / 2}, frames.all, 0);
    if (view.curves) view.values = values_of_keys(editor.session.document(), view.chosen, scales);
}

// The curve that has the numbers where each fills the height: the one under the mouse, else of the
// first chosen key, else the first.
TrackName leading_curve(const KeysView& view, const std::vector<TrackName>& shown,
                        const KeySpot* hot)
{
    if (hot) return hot->keys.front().track;
    for (const TrackName& name : shown)
        if (std::ranges::any_of(view.chosen, [&](const KeyName& key) { return key.track == name; }))
            return name;
    return shown.empty() ? TrackName{} : shown.front();
}

} // namespace

void draw_curves(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                 const ui::Rect& tracks, const FrameScale& frames)
{
    const ui::Palette& c = theme.color;
    Session& session = editor.session;
    KeysView& view = editor.timeline.keys;
    std::set<Id> all; // every track can be chosen here
    for (const Id id : animated_ids(session.document())) all.insert(id);
    ImGui::SetCursorScreenPos({names.lo.x, names.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("names", {names.width(), names.height()});
    std::vector<TimelineRow> rows = timeline_rows(session.document(), all);
    std::erase_if(rows, [&](const TimelineRow& row) {
        return row.kind == TimelineRow::Kind::travel ||
               tracks_of(session.document(), row.id).empty();
    });
    const std::vector<TrackName> shown =
        shown_curves(session.document(), view, session.selected.ids());
    const std::vector<ui::Color> colors = colors_of_curves(c, shown);
    const float first = ImGui::GetCursorScreenPos().y;
    const float end =
        draw_row_names(editor, theme, {{names.lo.x, 0}, {names.hi.x, 0}}, rows, first, false);
    paint_swatches(theme, names, rows, shown, colors, first);
    ImGui::SetCursorScreenPos({names.lo.x, end});
    ImGui::Dummy({1, 1});
    ImGui::EndChild();
    ImGui::PopStyleVar(2);

    const bool held = view.gesture.hand != KeyGesture::Hand::none;
    const bool alone = !shown.empty() && view.alone.value_or(units_differ(shown));
    if (alone != std::exchange(view.was_alone, alone)) view.values.reset();
    const float above = theme.px(shown.size() > 1 ? 36 : 18); // that button has its place
    CurveScales scales{{frames, tracks.lo.y + above, tracks.hi.y - theme.px(14)}, {}};
    CurveScale& scale = scales.all;
    if (alone) // as they were before a hand took one: nothing else moves under it
        for (const TrackName& name : shown)
            scales.own[name] =
                values_of_curves(held ? session.committed() : session.document(), {name});
    const glm::dvec2 usual = alone ? glm::dvec2(0, 1) : values_of_curves(session.document(), shown);
    scale.values = held && view.gesture.values != glm::dvec2(0) ? view.gesture.values
                                                                : view.values.value_or(usual);
    view.gesture.values = scale.values;
    ui::lower_area("curves", tracks,
                   ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    KeyField field;
    field.hovered = ImGui::IsItemHovered();
    const bool middle = ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    field.active = ImGui::IsItemActive() && !middle;
    field.activated = ImGui::IsItemActivated() && !middle;
    field.values = [&scales](const TrackName& name) { return scales.of(name).values; };
    field.reach_px = theme.px(9);
    field.meant = [&scale](glm::vec2 p) {
        return glm::dvec2(scale.frames.frame_at(p.x), scale.share_at(p.y));
    };
    field.spots = spots_of(session.document(), view, shown, scales);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const KeySpot* hot = field.hovered ? spot_at(field, {mouse.x, mouse.y}) : nullptr;
    ImGui::PushClipRect({tracks.lo.x, tracks.lo.y}, {tracks.hi.x, tracks.hi.y}, true);
    const TrackName leading = leading_curve(view, shown, hot);
    const NumberWords words = words_of_number(leading.parameter);
    const auto order = std::ranges::find(shown, leading) - shown.begin();
    const ui::Color of_leading = shown.empty() ? c.text_3 : colors[static_cast<std::size_t>(order)];
    const Values values = shown.empty() ? Values{} : values_in(theme, tracks, scales.of(leading));
    paint_lines(theme, tracks, values);
    paint_curves(theme, session.document(), view, shown, field, scales, colors, hot);
    paint_numbers(theme, tracks, values, units_differ(shown) && !alone ? "" : words.unit,
                  alone ? of_leading : c.text_3);
    const float now = std::round(frames.x(session.frame()));
    ui::paint_line({now, tracks.lo.y}, {now, tracks.hi.y}, c.focus, 1.5f * theme.scale);
    use_keys(editor, theme, field);
    paint_key_box(theme, view);
    ImGui::PopClipRect();
    look_round(editor, scale, field.hovered, ImGui::IsItemActive() && middle);
    if (hot && !hot->handle && view.gesture.hand == KeyGesture::Hand::none)
        ui::tooltip_in({hot->at - 8.0f, hot->at + 8.0f},
                       {words_of_number(hot->keys.front().track.parameter).label});
    fit_chosen(editor, frames, scales);
    if (shown.size() > 1) draw_alone(editor, theme, tracks, alone);
}

} // namespace trivar
