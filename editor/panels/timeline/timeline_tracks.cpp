// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/travel.h"
#include "core/placement/journey.h"
#include "editor/panels/timeline/timeline.h"
#include "editor/session/scene_facts.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using Hand = Editor::Timeline::Hand;

std::string speed_text(const Travel& travel)
{
    return ui::short_number(travel.speed) + " m/s";
}

// Returns the travel after a drag of so many frames. If the stroke decides its duration, pulling an
// end changes the speed; else the duration.
Travel dragged(const Editor::Timeline& t, const Journey& journey, int frames, double rate)
{
    Travel travel = t.travel;
    if (t.hand != Hand::end)
        travel.start_frame = std::clamp(travel.start_frame + frames, -999999, 999999);
    if (t.hand == Hand::shift) return travel;
    const bool by_speed =
        (travel.ends == Ends::stay || travel.ends == Ends::hide) && travel.duration == 0;
    if (t.hand == Hand::begin && !by_speed && travel.duration == 0) return travel; // without end
    const double end = t.hand == Hand::end ? t.to + frames : t.to;
    if (t.hand == Hand::begin)
        travel.start_frame = static_cast<int>(
            std::min<double>(travel.start_frame, std::max(std::floor(end) - 1, -999999.0)));
    const double seconds = std::max(1.0, end - travel.start_frame) / rate;
    if (by_speed)
        travel.speed = std::clamp(journey.speed_for(seconds), -1e6, 1e6);
    else
        travel.duration = std::min(seconds, 1e6);
    return travel;
}

void select(Session& session, Id id)
{
    if (ImGui::GetIO().KeyCtrl)
        session.selected.toggle(id);
    else if (!session.selected.contains(id))
        session.selected = id;
}

void begin_drag(Editor& editor, Id id, Hand hand, const TravelBar& bar, double frame)
{
    Session& session = editor.session;
    select(session, id);
    if (locked(session.document(), id) || session.committing()) return;
    editor.timeline.hand = hand;
    editor.timeline.id = id;
    editor.timeline.travel = object(session.document(), id).travel;
    editor.timeline.grabbed = frame;
    editor.timeline.from = bar.begin;
    editor.timeline.to = bar.end;
}

// The gesture while it goes on: each proposal starts from what was there, letting go is one step.
void drag(Editor& editor, const Journey& journey, double frame)
{
    Session& session = editor.session;
    Editor::Timeline& t = editor.timeline;
    const bool cancelled =
        ImGui::IsKeyPressed(ui::key_escape, false) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (cancelled) {
        session.cancel();
        t.hand = Hand::none;
        ImGui::ClearActiveID();
        return;
    }
    ui::hands().may_hold_on();
    const int frames = static_cast<int>(std::lround(std::clamp(frame - t.grabbed, -1e6, 1e6)));
    const Travel wanted =
        frames == 0 ? t.travel
                    : dragged(t, journey, frames, session.document().time.frames_per_second);
    if (wanted != object(session.document(), t.id).travel)
        session.propose(SetTravel{{t.id}, wanted});
}

Hand hand_over(const ui::Theme& theme, float x, float from, float to)
{
    const float grip = std::min(theme.px(6), (to - from) / 3);
    return x < from + grip ? Hand::begin : x > to - grip ? Hand::end : Hand::shift;
}

void paint_bar(const ui::Theme& theme, const ui::Rect& bar, bool selected, bool hot, bool endless,
               const std::string& words)
{
    const ui::Palette& c = theme.color;
    const float round = theme.size.rounding_small;
    ui::paint_box(bar, hot ? c.field_hover : selected ? c.field_fill : c.field, round);
    ui::paint_rim(bar, selected ? c.focus : c.text_off, round, theme.size.hairline);
    const ui::Rect in = {bar.lo + glm::vec2(theme.px(8), 0), bar.hi - glm::vec2(theme.px(8), 0)};
    constexpr const char* endless_words = "endless";
    const float width = ui::text_width(theme.font.small, words);
    if (width < in.width()) ui::paint_text(theme.font.small, in, c.text, words);
    const float both = width + theme.px(24) + ui::text_width(theme.font.small, endless_words);
    if (endless && both < in.width())
        ui::paint_text(theme.font.small, in, c.text_2, endless_words, ui::Align::right);
}

} // namespace

void let_go_of_bar(Editor& editor)
{
    Session& session = editor.session;
    Editor::Timeline& t = editor.timeline;
    if (t.hand == Hand::none) return;
    t.hand = Hand::none;
    if (!session.proposing()) return;
    if (object(session.document(), t.id).travel != t.travel)
        session.commit();
    else
        session.cancel();
}

void draw_travel_bar(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
                     const FrameScale& scale, Id id, bool by_hand)
{
    Session& session = editor.session;
    const auto bar = bar_of(session, id);
    if (!bar) return;
    const bool out_of_sight = scale.x(bar->end) < row.lo.x || scale.x(bar->begin) > row.hi.x;
    const bool dragged_here = editor.timeline.hand != Hand::none && editor.timeline.id == id;
    if (out_of_sight && !dragged_here) return;
    const float least = theme.px(6); // what rests at once can still be taken
    const float from = std::clamp(scale.x(bar->begin), row.lo.x, row.hi.x - least);
    const float to = std::clamp(scale.x(bar->end), from + least, row.hi.x);
    const ui::Rect r = {{from, row.lo.y + theme.px(3)}, {to, row.hi.y - theme.px(3)}};
    if (!by_hand) {
        paint_bar(theme, r, session.selected.contains(id), false, bar->endless, {});
        return;
    }
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::InvisibleButton("bar", {r.width(), r.height()});
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    const float mouse = ImGui::GetIO().MousePos.x;
    const double frame = scale.frame_at(mouse);
    Editor::Timeline& t = editor.timeline;
    if (ImGui::IsItemActivated())
        begin_drag(editor, id, hand_over(theme, mouse, from, to), *bar, frame);
    const bool held = t.hand != Hand::none && t.id == id;
    if (held && active) drag(editor, *session.evaluated().objects.at(id)->journey, frame);
    const Hand hand = held ? t.hand : hand_over(theme, mouse, from, to);
    if ((hovered && t.hand == Hand::none) || held)
        ImGui::SetMouseCursor(hand == Hand::shift ? ImGuiMouseCursor_Hand
                                                  : ImGuiMouseCursor_ResizeEW);
    const Travel& travel = object(session.document(), id).travel;
    const std::string words =
        held ? fmt::format("{}  ·  from frame {}", speed_text(travel), travel.start_frame)
             : speed_text(travel);
    paint_bar(theme, r, session.selected.contains(id), hovered || held, bar->endless, words);
    if (t.hand == Hand::none)
        ui::tooltip({name_of(session.document(), id),
                     {},
                     "Drag the bar to move it in time, or an end to change its speed."});
}

} // namespace trivar
