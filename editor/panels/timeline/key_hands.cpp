// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline/key_hands.h"

#include "core/commands/words/number_words.h"
#include "editor/actions/key_actions.h"
#include "ui/input.h"
#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using KeyHand = KeyGesture::Hand;

glm::vec2 mouse_px()
{
    const ImVec2 p = ImGui::GetIO().MousePos;
    return {p.x, p.y};
}

// Proposes the edit; without one, cancels the proposal.
void show_edit(Editor& editor, KeyEdit edit)
{
    KeysView& view = editor.timeline.keys;
    if (!edit.command)
        editor.session.cancel();
    else if (!editor.session.propose(*edit.command))
        return;
    view.chosen = std::move(edit.keys);
}

void begin(Editor& editor, const KeyField& field, KeyHand hand, bool by_key)
{
    KeysView& view = editor.timeline.keys;
    if (editor.session.committing() || editor.session.proposing()) return;
    KeyGesture g;
    g.hand = hand;
    g.by_key = by_key;
    g.before = view.chosen;
    g.grabbed_px = mouse_px();
    g.grabbed = field.meant(g.grabbed_px);
    g.about = editor.session.frame();
    g.values = view.gesture.values;
    if (!view.chosen.empty()) g.key = *view.chosen.begin();
    view.gesture = g;
}

void press(Editor& editor, const KeyField& field)
{
    KeysView& view = editor.timeline.keys;
    const ImGuiIO& io = ImGui::GetIO();
    const bool adds = io.KeyCtrl || io.KeyShift;
    const KeySpot* spot = spot_at(field, mouse_px());
    if (!spot) return begin(editor, field, KeyHand::box, false);
    const Id id = spot->keys.front().track.id;
    const bool stays = id != 0 && locked(editor.session.document(), id);
    if (spot->handle && stays) return;
    if (spot->handle) {
        begin(editor, field, KeyHand::handle, false);
        view.gesture.key = spot->keys.front();
        view.gesture.which = *spot->handle;
        return;
    }
    if (adds && is_chosen(view, spot->keys)) {
        for (const KeyName& key : spot->keys) view.chosen.erase(key);
        return;
    }
    if (!adds && !is_chosen(view, spot->keys)) view.chosen.clear();
    view.chosen.insert(spot->keys.begin(), spot->keys.end());
    if (!adds && id != 0 && !editor.session.selected.contains(id)) editor.session.selected = id;
    if (stays) return;
    begin(editor, field, io.KeyAlt ? KeyHand::copy : KeyHand::move, false);
    view.gesture.key = spot->keys.front();
}

void choose_in_box(KeysView& view, const KeyField& field)
{
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 a = view.gesture.grabbed_px, b = mouse_px();
    const ui::Rect box{glm::min(a, b), glm::max(a, b) + 1.0f};
    view.chosen = io.KeyCtrl || io.KeyShift ? view.gesture.before : ChosenKeys{};
    if (!view.gesture.strayed) return;
    for (const KeySpot& spot : field.spots)
        if (!spot.handle && box.contains(spot.at))
            view.chosen.insert(spot.keys.begin(), spot.keys.end());
}

void go_on(Editor& editor, const KeyField& field)
{
    constexpr float least_px = 3;
    KeysView& view = editor.timeline.keys;
    KeyGesture& g = view.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse = mouse_px();
    g.strayed = g.strayed || glm::distance(mouse, g.grabbed_px) > least_px;
    if (g.hand == KeyHand::box) return choose_in_box(view, field);
    if (!g.strayed) return;
    const Document& before = editor.session.committed();
    const glm::dvec2 at = field.meant(mouse), way = (at - g.grabbed) * (io.KeyShift ? 0.1 : 1.0);
    // Converts a share of the height to the stored value.
    const auto stored = [&](const TrackName& track, double share, bool difference) {
        const glm::dvec2 shown = field.values(track);
        return ((difference ? 0 : shown.x) + share * (shown.y - shown.x)) /
               words_of_number(track.parameter).factor;
    };
    if (g.hand == KeyHand::handle)
        return show_edit(editor, with_handle(before, g.key, g.which,
                                             {at.x, stored(g.key.track, at.y, false)}, io.KeyAlt));
    if (g.hand == KeyHand::scale) {
        const double from = g.grabbed.x - g.about;
        const double reach = std::abs(from) < 1 ? std::copysign(1.0, from) : from;
        return show_edit(editor, scaled(before, g.before, g.about, (from + way.x) / reach));
    }
    const double frames = io.KeyCtrl ? way.x : std::round(way.x);
    // A hand that goes sideways leaves the values.
    const bool up = field.values && std::abs(mouse.y - g.grabbed_px.y) > least_px;
    TrackRise rise;
    if (up) rise = [&](const TrackName& track) { return stored(track, way.y, true); };
    show_edit(editor, g.hand == KeyHand::copy ? copied(before, g.before, frames)
                                              : moved(before, g.before, frames, rise));
}

void end(Editor& editor, const KeyField& field, bool cancelled)
{
    KeysView& view = editor.timeline.keys;
    if (cancelled) {
        editor.session.cancel();
        view.chosen = view.gesture.before;
        ImGui::ClearActiveID();
    } else if (view.gesture.hand == KeyHand::box)
        choose_in_box(view, field);
    else if (editor.session.proposing())
        editor.session.commit();
    view.gesture = {};
}

void run_edit(Editor& editor, const KeyEdit& edit)
{
    if (edit.command && !editor.session.proposing() && editor.session.run(*edit.command))
        editor.timeline.keys.chosen = edit.keys;
}

void key_menu(Editor& editor)
{
    if (!ImGui::BeginPopup("keys menu")) return;
    const Document& document = editor.session.committed();
    const ChosenKeys& chosen = editor.timeline.keys.chosen;
    const auto item = [&](const char* words, bool on, auto&& edit) {
        if (ImGui::MenuItem(words, nullptr, on)) run_edit(editor, edit());
    };
    const Key* first = chosen.empty() ? nullptr : key_of(document, *chosen.begin());
    const Track* track = first ? track_of(document, chosen.begin()->track) : nullptr;
    if (!track) {
        ImGui::EndPopup();
        return;
    }
    ImGui::TextDisabled("To the next key");
    for (const auto& [words, tween] : {std::pair("Step", Tween::step),
                                       {"Linear", Tween::linear},
                                       {"Cubic", Tween::cubic},
                                       {"Settle", Tween::settle}})
        item(words, first->tween == tween,
             [&, to = tween] { return with_tween(document, chosen, to); });
    item("Smooth handles", false, [&] { return smoothed(document, chosen); });
    ImGui::Separator();
    ImGui::TextDisabled("After the last key");
    for (const auto& [words, repeat] : {std::pair("Stay", Repeat::once),
                                        {"Loop", Repeat::loop},
                                        {"Back and forth", Repeat::back_and_forth}})
        item(words, track->repeat == repeat,
             [&, to = repeat] { return with_repeat(document, chosen, to); });
    ImGui::Separator();
    const double there = editor.session.frame() - chosen.begin()->frame;
    item("Copy to this frame", false, [&] { return copied(document, chosen, there); });
    item("Delete", false, [&] { return without(document, chosen); });
    ImGui::EndPopup();
}

} // namespace

const KeySpot* spot_at(const KeyField& field, glm::vec2 p)
{
    const KeySpot* best = nullptr;
    float nearest = field.reach_px;
    for (const KeySpot& spot : field.spots)
        if (const float d = glm::distance(spot.at, p); d <= nearest) {
            best = &spot;
            nearest = d;
        }
    return best;
}

bool is_chosen(const KeysView& view, const std::vector<KeyName>& keys)
{
    return std::ranges::all_of(keys, [&](const KeyName& key) { return view.chosen.contains(key); });
}

void use_keys(Editor& editor, const ui::Theme& theme, const KeyField& field)
{
    KeysView& view = editor.timeline.keys;
    KeyGesture& g = view.gesture;
    if (g.hand == KeyHand::none) {
        view.chosen = present_keys(editor.session.document(), std::move(view.chosen));
        if (view.asked && !view.chosen.empty())
            begin(editor, field, *view.asked, true);
        else if (field.activated)
            press(editor, field);
        else if (field.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            const KeySpot* spot = spot_at(field, mouse_px());
            if (spot && !is_chosen(view, spot->keys))
                view.chosen = {spot->keys.begin(), spot->keys.end()};
            if (spot) ImGui::OpenPopup("keys menu");
        }
    } else {
        const bool cancelled = ImGui::IsKeyPressed(ui::key_escape, false) ||
                               ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        const bool ended = g.by_key ? ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                                          ImGui::IsKeyPressed(ui::key_enter, false)
                                    : !field.active;
        if (!cancelled && !ended) {
            if (!g.by_key) ui::hands().may_hold_on();
            go_on(editor, field);
        } else {
            end(editor, field, cancelled);
        }
    }
    view.asked.reset();
    const bool over = g.hand == KeyHand::none && field.hovered && spot_at(field, mouse_px());
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (g.hand == KeyHand::move || g.hand == KeyHand::copy || g.hand == KeyHand::scale)
        ImGui::SetMouseCursor(field.values ? ImGuiMouseCursor_ResizeAll
                                           : ImGuiMouseCursor_ResizeEW);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(8), theme.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(8), theme.px(4)});
    key_menu(editor);
    ImGui::PopStyleVar(2);
}

void paint_key_box(const ui::Theme& theme, const KeysView& view)
{
    const KeyGesture& g = view.gesture;
    if (g.hand != KeyHand::box || !g.strayed) return;
    const glm::vec2 mouse = mouse_px();
    const ui::Rect box{glm::min(g.grabbed_px, mouse), glm::max(g.grabbed_px, mouse)};
    ui::paint_box(box, ui::faded(theme.color.focus, 0.15f));
    ui::paint_rim(box, theme.color.focus, 0, theme.size.hairline);
}

} // namespace trivar
