// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline/timeline.h"

#include "core/commands/objects/view.h"
#include "editor/actions/key_actions.h"
#include "editor/actions/time_actions.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/session/scene_facts.h"
#include "editor/words/field_words.h"
#include "ui/icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// A Transport places parts side by side, from the left; each places ImGui's cursor for the next.
struct Transport {
    const ui::Theme& theme;
    ui::Rect bar;
    float x;
    void place(float height) const
    {
        ImGui::SetCursorScreenPos({x, std::round(bar.center().y - height / 2)});
    }
    bool icon(const char* id, const char* icon, const ui::Tip& tip, const ui::IconState& state = {})
    {
        const float side = theme.size.icon_button;
        place(side);
        const bool clicked = ui::icon_button(theme, id, icon, glm::vec2(side), tip, state);
        x += side + theme.px(4);
        return clicked;
    }
    void field(float width, const auto& draw)
    {
        place(theme.size.row);
        draw(theme.px(width));
        x += theme.px(width + 4);
    }
    void words(const char* text)
    {
        ui::paint_text(theme.font.small, {{x, bar.lo.y}, bar.hi}, theme.color.text_2, text);
        x += ui::text_width(theme.font.small, text) + theme.px(6);
    }
};

void buttons(Editor& editor, Transport& line, bool steps)
{
    const bool playing = editor.playback.playing();
    const Time& time = editor.session.document().time;
    const int frame = editor.session.frame();
    struct Button {
        const char *name, *icon, *says;
        bool enabled = true;
    };
    const std::array<Button, 5> all{
        {{first_frame_action, ui::icon::first, "Go to the first frame.", frame > time.first_frame},
         {previous_frame_action, ui::icon::back, "", frame > time.first_frame},
         {play_action, playing ? ui::icon::pause : ui::icon::play,
          "Plays in real time; late frames are skipped."},
         {next_frame_action, ui::icon::forward, "", frame < time.last_frame},
         {last_frame_action, ui::icon::last, "Go to the last frame.", frame < time.last_frame}}};
    for (const Button& each : all) {
        if (!steps && std::string_view(each.name) != play_action) continue;
        const Action& does = action(editor, each.name);
        if (line.icon(each.name, each.icon, tip_of(editor, does, each.says),
                      {.enabled = each.enabled}))
            does.run(editor);
    }
    const Action& again = action(editor, loop_action);
    if (editor.preferences.loop) {
        const glm::vec2 side(line.theme.size.icon_button);
        ui::paint_box(ui::rect_at({line.x, std::round(line.bar.center().y - side.y / 2)}, side),
                      line.theme.color.segment, line.theme.size.rounding_small);
    }
    if (line.icon(loop_action, ui::icon::again,
                  tip_of(editor, again, "Starts again after the last frame.")))
        again.run(editor);
    const ui::Palette& c = line.theme.color;
    const glm::vec2 dot{line.x + line.theme.size.icon_button / 2, line.bar.center().y};
    const Action& auto_key = action(editor, auto_key_action);
    if (line.icon(auto_key_action, "",
                  tip_of(editor, auto_key,
                         "Every change of an animatable number sets a key in the current frame. "
                         "The viewport has a red border meanwhile.")))
        auto_key.run(editor);
    if (editor.session.auto_key)
        ui::paint_dot(dot, line.theme.px(6), c.bad);
    else
        ui::paint_dot(dot, line.theme.px(5), c.header, c.text_2, 1.5f * line.theme.scale);
    line.x += line.theme.px(8);
}

// Room says which parts fit beside the ruler, or in the open timeline beside the numbers of the
// chosen keys; the least wanted go first.
struct Room {
    bool title = true, rate = true, range = true,
         steps = true; // steps: to other frames, by buttons
};
constexpr float title_width = 72, rate_width = 72, range_width = 146, rest_width = 320,
                steps_width = 4 * 32, least_ruler = 140, least_key_numbers = 172;
Room room_in(const Editor& editor, const ui::Theme& theme, float width)
{
    const bool open = editor.preferences.timeline_open;
    Room room;
    float needed = theme.px(title_width + rate_width + range_width + rest_width);
    const auto drop = [&](bool& part, float part_width) {
        if (needed <= width) return;
        part = false;
        needed -= theme.px(part_width);
    };
    if (!open) needed += theme.px(least_ruler);
    drop(room.title, title_width); // whatever is chosen: buttons stay where they are
    if (open && !editor.timeline.keys.chosen.empty()) needed += theme.px(least_key_numbers);
    drop(room.rate, rate_width);
    drop(room.range, range_width);
    if (!open) drop(room.steps, steps_width); // the ruler shows the range and goes to any frame
    return room;
}

// The title too is pressed, as those of sections are.
void timeline_heading(Editor& editor, Transport& line, bool has_title)
{
    const ui::Theme& theme = line.theme;
    const bool open = editor.preferences.timeline_open;
    const char* title = "Timeline";
    const float side = theme.size.icon_button, gap = theme.px(4);
    const float words = has_title ? gap + ui::text_width(theme.font.strong, title) + gap : 0;
    const Action& toggle = action(editor, timeline_action);
    line.place(side);
    if (ui::icon_button(theme, "open", "", {side + words, side},
                        {open ? "Close the timeline" : "Open the timeline", key_text(toggle),
                         "Keys and travelling objects over time; select and drag them."}))
        toggle.run(editor);
    ui::paint_text(theme.font.body, {{line.x, line.bar.lo.y}, {line.x + side, line.bar.hi.y}},
                   theme.color.text_2, open ? ui::icon::open : ui::icon::closed, ui::Align::center);
    line.x += side + gap;
    if (!has_title) return;
    ui::paint_text(theme.font.strong, {{line.x, line.bar.lo.y}, line.bar.hi}, theme.color.text,
                   title);
    line.x += theme.px(title_width);
}

void numbers(Editor& editor, Transport& line, const Room& room)
{
    Session& session = editor.session;
    const ui::Theme& theme = line.theme;
    Time t = session.document().time;
    int frame = session.frame();
    line.field(60, [&](float width) {
        const ui::NumberStyle style{.lo = static_cast<double>(t.first_frame),
                                    .hi = static_cast<double>(t.last_frame)};
        if (ui::integer_field(theme, "frame", frame, style, width) != ui::Edit::none) {
            editor.playback.pause();
            session.show_frame(frame);
        }
        ui::tooltip({"Frame", {}, "The current frame."});
    });
    ui::Edit edit = ui::Edit::none;
    const auto take = [&edit](ui::Edit one) {
        if (one != ui::Edit::none) edit = one;
    };
    const auto tip = [](const char* name, const char* field) {
        ui::tooltip({name, {}, help_of_field("set_time", field)});
    };
    if (room.range) {
        line.words("of");
        line.field(48, [&](float width) {
            take(ui::integer_field(theme, "first", t.first_frame,
                                   {.lo = -999999, .hi = static_cast<double>(t.last_frame)},
                                   width));
            tip("First frame", "first_frame");
        });
        line.words("to");
        line.field(48, [&](float width) {
            take(ui::integer_field(theme, "last", t.last_frame,
                                   {.lo = static_cast<double>(t.first_frame), .hi = 999999},
                                   width));
            tip("Last frame", "last_frame");
        });
    }
    if (room.rate)
        line.field(68, [&](float width) {
            take(ui::number_field(theme, "rate", t.frames_per_second,
                                  {.lo = 0.1, .hi = 1000, .step = 1, .unit = "fps"}, width));
            tip("Frames per second", "frames_per_second");
        });
    propose_edit(editor, edit, [&] { return SetTime{t}; });
    line.x += theme.px(8);
}

// Steps that people count in, so that the words of two do not meet.
int tick_step(const FrameScale& scale, float least_px)
{
    const float per_frame = scale.x(scale.first + 1) - scale.x(scale.first);
    for (int unit = 1; unit < 1000000; unit *= 10)
        for (const int factor : {1, 2, 5})
            if (per_frame * static_cast<float>(unit * factor) >= least_px) return unit * factor;
    return 1000000;
}

// With the session, numbers beside the tag of its frame.
void paint_ticks(const ui::Theme& theme, const ui::Rect& r, const FrameScale& s, const Session* of)
{
    const int step = tick_step(s, theme.px(56)), small = tick_step(s, theme.px(8));
    const double last = std::min(s.all.y, std::ceil(s.frame_at(r.hi.x)));
    const auto first_of = [&](int every) {
        const int first = static_cast<int>(std::floor(std::max(s.all.x, s.frame_at(r.lo.x))));
        return first + ((every - first % every) % every + every) % every;
    };
    for (int f = first_of(small); f <= last; f += small) {
        const float h = theme.px(f % step == 0 ? 6 : 3), x = std::round(s.x(f));
        ui::paint_line({x, r.hi.y - h}, {x, r.hi.y}, theme.color.text_off, theme.size.hairline);
    }
    for (int f = first_of(step); of && f <= last; f += step) {
        const float x = s.x(f), half = theme.px(24), mark = theme.px(28);
        if (s.all.x < s.first && x - half < r.lo.x + mark) continue; // it stands there
        if (s.all.y > s.last && x + half > r.hi.x - mark) continue;
        if (std::abs(x - s.x(of->frame())) < theme.px(32)) continue;
        ui::paint_text(theme.font.small, {{x - half, r.lo.y}, {x + half, r.hi.y - theme.px(4)}},
                       theme.color.text_2, std::to_string(f), ui::Align::center);
    }
}

// The whole width of a ruler takes the mouse and shows the frame under it.
void scrub(Editor& editor, const ui::Rect& r, const FrameScale& scale)
{
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::InvisibleButton("ruler", {std::max(1.0f, r.width()), std::max(1.0f, r.height())});
    if (!ImGui::IsItemActive()) return;
    ui::hands().may_hold_on();
    editor.playback.pause();
    const double frame = std::clamp(scale.frame_at(ImGui::GetIO().MousePos.x), -1e6, 1e6);
    editor.session.show_frame(static_cast<int>(std::lround(frame)));
}

// The wheel over the ruler, or with Ctrl anywhere in it, zooms; with Shift, or sideways, it rolls.
void zoom(Editor& editor, const ui::Rect& ruler, const ui::Rect& tracks, const FrameScale& scale)
{
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse{io.MousePos.x, io.MousePos.y};
    const bool over = ruler.contains(mouse);
    if (!editor.timeline.hovered || (!over && !tracks.contains(mouse))) return;
    const glm::dvec2 before(scale.first, scale.last);
    glm::dvec2 shown = before;
    const double up{io.MouseWheel}, aside{io.MouseWheelH};
    if (up == 0 && aside == 0) return;
    if (io.KeyShift || aside != 0)
        shown = rolled_frames(shown, scale.all, io.KeyShift ? up : aside);
    else if (over || io.KeyCtrl)
        shown = zoomed_frames(shown, scale.all, scale.frame_at(mouse.x), up);
    if (shown == before) return;
    editor.timeline.shown = kept_frames(shown, scale.time);
}

// Scrolls so that the playhead stays in sight.
void follow_playhead(Editor& editor)
{
    std::optional<glm::dvec2>& shown = editor.timeline.shown;
    const double frame = editor.session.frame();
    if (!shown || !editor.playback.playing() || (frame >= shown->x && frame <= shown->y)) return;
    const double width = shown->y - shown->x;
    const Time& time = editor.session.document().time;
    shown->x = std::min(frame, time.last_frame - width);
    shown->y = shown->x + width;
}

void paint_playhead(const ui::Theme& theme, const ui::Rect& r, const FrameScale& scale,
                    const Session& session, bool numbered)
{
    const ui::Palette& c = theme.color;
    const int frame = session.frame();
    const ui::Color color = session.auto_key ? c.bad : c.focus;
    const float x = std::round(scale.x(frame));
    ui::paint_line({x, r.lo.y}, {x, r.hi.y}, color, 1.5f * theme.scale);
    if (!numbered) {
        ui::paint_dot({x, r.lo.y + theme.px(3)}, theme.px(3), color);
        return;
    }
    const std::string text = std::to_string(frame);
    const float half = ui::text_width(theme.font.small_strong, text) / 2 + theme.px(6);
    const ui::Rect tag = {{x - half, r.lo.y + theme.px(2)}, {x + half, r.lo.y + theme.px(22)}};
    ui::paint_box(tag, session.auto_key ? c.bad_fill : c.accent, theme.size.rounding_small);
    ui::paint_text(theme.font.small_strong, tag, c.on_accent, text, ui::Align::center);
}

// Thin, one under the other, as many as there is room for; the rest lie on the last.
void paint_thin_bars(const Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                     const FrameScale& scale)
{
    constexpr std::size_t most = 4;
    const ui::Palette& c = theme.color;
    const float pitch = theme.px(5), thick = theme.px(3), middle = std::round(r.center().y);
    const std::vector<Id> ids = travelling(editor.session.document());
    ui::paint_line({scale.lo, middle}, {scale.hi, middle}, c.line_soft, theme.size.hairline);
    const auto below = static_cast<float>(std::min(ids.size(), most)) - 1;
    const float first = std::round(middle - (below * pitch + thick) / 2);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto bar = bar_of(editor.session, ids[i]);
        if (!bar) continue;
        const float from = std::clamp(scale.x(bar->begin), scale.lo, scale.hi);
        const float to = std::clamp(scale.x(bar->end), scale.lo, scale.hi);
        const float y = first + static_cast<float>(std::min(i, most - 1)) * pitch;
        const bool selected = editor.session.selected.contains(ids[i]);
        if (to > from)
            ui::paint_box({{from, y}, {to, y + thick}}, selected ? c.focus : c.text_3, thick / 2);
    }
}

// Paints the keys of all objects, those of the selected ones on top.
void paint_key_strip(const Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                     const FrameScale& scale)
{
    const ui::Palette& c = theme.color;
    const Document& document = editor.session.document();
    const std::vector<Id> ids = animated_ids(document);
    std::vector<Id> selected;
    for (const Id id : ids)
        if (editor.session.selected.contains(id)) selected.push_back(id);
    const float y = std::round(r.center().y);
    const auto paint = [&](const std::vector<Id>& of, ui::Color fill) {
        for (const double frame : key_frames(document, of))
            if (frame >= scale.first && frame <= scale.last)
                ui::paint_diamond({scale.x(frame), y}, theme.px(4) + 0.5f, fill, c.key,
                                  theme.size.hairline);
    };
    paint(ids, c.header);
    paint(selected, c.key);
}

// The frames that are none of the scene's.
void paint_outside(const ui::Theme& theme, const ui::Rect& r, const FrameScale& scale)
{
    const auto paint = [&](float from, float to) {
        if (to > from) ui::paint_box({{from, r.lo.y}, {to, r.hi.y}}, theme.color.gap);
    };
    if (scale.all.x < scale.time.first_frame)
        paint(r.lo.x, std::round(scale.x(scale.time.first_frame)));
    if (scale.all.y > scale.time.last_frame)
        paint(std::round(scale.x(scale.time.last_frame)), r.hi.x);
}

// At the upper left of the open timeline: how keys are shown, and room for what travels.
void draw_corner(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const Action& room = action(editor, make_room_action);
    const bool needs_room = is_enabled(editor, room);
    const float wide =
        needs_room ? ui::text_width(theme.font.body, "Extend range") + theme.px(16) : 0;
    KeysView& view = editor.timeline.keys;
    const float width = std::min(theme.px(112), r.width() - wide - theme.px(16));
    if (width > theme.px(80)) {
        ImGui::SetCursorScreenPos({r.lo.x + theme.px(8), r.lo.y});
        int curves = view.curves ? 1 : 0;
        // The panel keeps its height, so that its head stays under the hand.
        if (ui::segments(theme, "shown", curves, {"Keys", "Curves"}, width) == ui::Edit::changed)
            view.curves = curves == 1;
        ui::tooltip({"Keys or curves", {}, "Keys in time, or the curves between them."});
    }
    if (!needs_room) return;
    ImGui::SetCursorScreenPos({r.hi.x - wide, r.lo.y});
    const bool pressed =
        ui::button(theme, "Extend range", ui::ButtonKind::quiet, {wide, r.height()});
    ui::tooltip(tip_of(editor, room,
                       "Something is still moving in the last frame. Extends the range by whole "
                       "seconds until everything has arrived."));
    if (pressed) room.run(editor);
}

void draw_open(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    const float split = names_end(theme, r);
    const float line = theme.size.hairline, under = r.lo.y + theme.px(24);
    ui::paint_box(r, c.base);
    ui::paint_box({r.lo, {split, r.hi.y}}, c.panel);
    follow_playhead(editor);
    const FrameScale scale = track_scale(theme, r, editor);
    draw_corner(editor, theme, {r.lo, {split, under - line}});
    const ui::Rect ruler = {{split + line, r.lo.y}, {r.hi.x, under}};
    ImGui::PushClipRect({ruler.lo.x, ruler.lo.y}, {ruler.hi.x, r.hi.y}, true);
    paint_outside(theme, {ruler.lo, r.hi}, scale);
    paint_ticks(theme, ruler, scale, &editor.session);
    ImGui::PopClipRect();
    draw_marks_of_keys(editor, theme, ruler, scale); // before the ruler, whose clicks they take
    scrub(editor, ruler, scale);
    ui::paint_box({{r.lo.x, under - line}, {r.hi.x, under}}, c.gap);
    const ui::Rect names = {{r.lo.x, under}, {split, r.hi.y}};
    const ui::Rect tracks = {{split + line, under}, r.hi};
    zoom(editor, ruler, tracks, scale);
    const bool has_keys = !animated_ids(editor.session.document()).empty();
    const bool curves = editor.timeline.keys.curves;
    if (!has_keys && (curves || travelling(editor.session.document()).empty())) {
        const std::string key = key_text(action(editor, insert_key_action));
        ui::empty_state(theme, tracks, ui::icon::travel, "No keys yet",
                        "Hover over a value and press " +
                            (key.empty() ? std::string("its diamond") : key) +
                            ", or let something travel.");
    } else if (curves)
        draw_curves(editor, theme, names, tracks, scale);
    else
        draw_key_rows(editor, theme, names, tracks, scale);
    ui::paint_box({{split, r.lo.y}, {split + line, r.hi.y}}, c.gap);
    // Over everything, and only over the frames.
    ImGui::PushClipRect({ruler.lo.x, r.lo.y}, {r.hi.x, r.hi.y}, true);
    paint_playhead(theme, {ruler.lo, r.hi}, scale, editor.session, true);
    ImGui::PopClipRect();
}

} // namespace

void draw_timeline(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.timeline;
    const bool open = editor.preferences.timeline_open;
    begin_panel("timeline", r, c.header);
    editor.timeline.hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    const ui::Rect bar = {r.lo, {r.hi.x, std::min(r.hi.y, r.lo.y + theme.px(40))}};
    const Room room = room_in(editor, theme, r.width());
    Transport line{theme, bar, r.lo.x + theme.px(8)};
    timeline_heading(editor, line, room.title);
    buttons(editor, line, room.steps);
    numbers(editor, line, room);
    const Time& time = editor.session.document().time;
    const FrameScale scale{line.x + theme.px(12),
                           bar.hi.x - theme.px(20),
                           static_cast<double>(time.first_frame),
                           static_cast<double>(time.last_frame),
                           time,
                           {time.first_frame, time.last_frame}};
    if (!open && scale.hi - scale.lo > theme.px(64)) {
        const ui::Rect ruler = {{line.x, bar.lo.y}, bar.hi};
        paint_ticks(theme, {ruler.lo, ruler.hi - glm::vec2(0, theme.px(4))}, scale, nullptr);
        paint_thin_bars(editor, theme, ruler, scale);
        paint_key_strip(editor, theme, ruler, scale);
        scrub(editor, ruler, scale);
        paint_playhead(theme,
                       {{ruler.lo.x, ruler.lo.y + theme.px(3)}, ruler.hi - glm::vec2(theme.px(4))},
                       scale, editor.session, false);
    }
    if (open) draw_key_numbers(editor, theme, {{line.x, bar.lo.y}, bar.hi});
    if (open) draw_open(editor, theme, {{r.lo.x, bar.hi.y}, r.hi});
    ImGui::End();
}

} // namespace trivar
