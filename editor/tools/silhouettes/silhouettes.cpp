// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/silhouettes/silhouettes.h"

#include "editor/hands/level_under.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_names.h"
#include "editor/session/volume_levels.h"
#include "ui/input.h"
#include "ui/level_field.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

constexpr double drag_range_px = 600; // over which a drag goes through all values
constexpr double halt_reach_px = 6;   // of the hand
constexpr double wheel_steps = 200;   // of the wheel through all values

const VolumeSummary* summary_at(const Session& session, Id id)
{
    const ShownVolume* shown = shown_volume_of(session, id);
    return shown ? shown->summary.get() : nullptr;
}

// Values at which a dragged level halts; none until they are known.
std::span<const double> plateaus_at(Session& session, Id id)
{
    const ShownVolume* shown = shown_volume_of(session, id);
    const ScoutedVolume* scouted =
        shown ? session.level_scouts.of(session.quiet_jobs(), *shown) : nullptr;
    return scouted ? std::span(scouted->plateaus) : std::span<const double>();
}

} // namespace

ToolState SilhouettesTool::state() const
{
    return {.busy = gesture_.going(), .takes_wheel = turns_level()};
}

void SilhouettesTool::begin(Session& session)
{
    const Id id = volume_at_work(session.document(), session.selected);
    if (id != 0 && session.selected != id) session.selected = id;
}

bool SilhouettesTool::turns_level() const
{
    return levels_ > 0 && ImGui::GetIO().KeyCtrl;
}

// The digits choose a level here, where there are several, and no tool.
bool SilhouettesTool::awaits(const ui::Chord& chord) const
{
    return levels_ > 1 && !chord.ctrl && !chord.shift && !chord.alt && chord.key >= '1' &&
           chord.key < '1' + std::min(9, levels_);
}

void SilhouettesTool::use(Session& session, const ViewportInput& input)
{
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* shape = volume_of(session.document(), id);
    levels_ = shape ? static_cast<int>(shape->levels.size()) : 0;
    const std::span<const double> plateaus = plateaus_at(session, id); // looked for from now on
    if (session.committing()) return;
    if (gesture_ && !gesture_->by_wheel) return drag(session, input, plateaus);
    turn_wheel(session, input);
    if (gesture_) return;
    if (!ImGui::GetIO().WantTextInput && input.hovered) take_digits(session);
    if (input.pressed) press(session, input);
}

void SilhouettesTool::take_digits(Session& session) const
{
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* shape = volume_of(session.document(), id);
    if (!shape || shape->levels.size() < 2) return;
    for (int n = 0; n < std::min<int>(9, static_cast<int>(shape->levels.size())); ++n)
        if (ui::struck({'1' + n})) session.level = {id, n};
}

void SilhouettesTool::press(Session& session, const ViewportInput& input)
{
    const Id id = volume_at_work(session.document(), session.selected);
    // Another object that is not volume data is selected as by any tool.
    if (input.under != 0 && input.under != id) {
        select_by_click(session, input.under);
        const VoxelShape* other = volume_of(session.document(), input.under);
        if (!other) return;
    }
    const Id at_work = volume_of(session.document(), input.under) ? input.under : id;
    const VoxelShape* shape = volume_of(session.document(), at_work);
    if (!shape || shape->levels.empty()) return;
    session.selected = at_work;
    if (const std::optional<int> level =
            level_under(session, at_work, input.mouse, 8 * input.scale))
        session.level = {at_work, *level};
    const int chosen = chosen_in(*shape, at_work, session.level);
    session.level = {at_work, chosen};
    const double value = shape->levels[static_cast<std::size_t>(chosen)].value;
    gesture_.begin({at_work, chosen, value, value, 0, false, input.mouse}, input);
}

// Nothing where the value came back.
std::optional<Command> SilhouettesTool::wanted(const Session& session) const
{
    const auto level = static_cast<std::size_t>(gesture_->level);
    const VoxelShape* shape = volume_of(session.document(), gesture_->object);
    if (!shape || level >= shape->levels.size() || gesture_->value == gesture_->from_value)
        return {};
    SetVoxels set{gesture_->object, *shape};
    set.shape.levels[level].value = gesture_->value;
    return set;
}

void SilhouettesTool::drag(Session& session, const ViewportInput& input,
                           std::span<const double> plateaus)
{
    Change& d = *gesture_;
    const VolumeSummary* summary = summary_at(session, d.object);
    const double step = d.last_px.y - input.mouse.y; // upward raises the value
    d.last_px = input.mouse;
    const double fine = ImGui::GetIO().KeyShift ? 0.1 : 1;
    d.shift += step * fine;
    d.moved = d.moved || std::abs(d.shift) > click_slip_px * input.scale;
    if (d.moved && summary && step != 0) {
        const double range = summary->greatest - summary->least;
        const double per_px = range / (drag_range_px * input.scale);
        const double by_hand = d.from_value + d.shift * per_px;
        const double reach =
            ImGui::GetIO().KeyCtrl ? 0 : halt_reach_px * input.scale * fine * per_px;
        const double value = ui::snapped(plateaus, by_hand, reach);
        d.halted = std::ranges::find(plateaus, value) != plateaus.end();
        d.value = readable_value(value, *summary);
    }
    gesture_.go_on(session, input, [&] { return wanted(session); });
}

void SilhouettesTool::turn_wheel(Session& session, const ViewportInput& input)
{
    const auto now = [&] { return wanted(session); };
    if (gesture_ && !ImGui::GetIO().KeyCtrl) gesture_.finish(session, now);
    if (turns_level() && input.hovered && input.wheel != 0) {
        const Id id = volume_at_work(session.document(), session.selected);
        const VoxelShape* shape = volume_of(session.document(), id);
        const VolumeSummary* summary = summary_at(session, id);
        if (!shape || !summary) return;
        const int chosen = chosen_in(*shape, id, session.level);
        const double value = shape->levels[static_cast<std::size_t>(chosen)].value;
        if (!gesture_) gesture_.begin({id, chosen, value, value, 0, true}, input);
        gesture_->shift += input.wheel;
        const double range = summary->greatest - summary->least;
        gesture_->value =
            readable_value(gesture_->from_value + gesture_->shift * range / wheel_steps, *summary);
    }
    if (gesture_) gesture_.show(session, now);
}

void SilhouettesTool::take_keys(Session& session)
{
    if (gesture_.take_keys()) gesture_.finish(session, [&] { return wanted(session); });
}

void SilhouettesTool::cancel(Session& session)
{
    gesture_.cancel(session);
}

std::vector<Hint> SilhouettesTool::hints(const Session& session) const
{
    if (gesture_ && !gesture_->by_wheel)
        return {{{"left"}, "Up and down: the level"},
                {{"Shift"}, "Finer"},
                {{"Ctrl"}, "Halts nowhere"},
                {{"Esc"}, "Cancel"}};
    if (gesture_) return {{{"Ctrl"}, "Let go when done"}, {{"Esc"}, "Cancel"}};
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* shape = volume_of(session.document(), id);
    if (!shape)
        return {{{"left"}, "Select volume data"},
                {{"@Import model..."}, "Import"},
                {{"Esc"}, "Select"}};
    if (shape->levels.empty()) return {{{"Esc"}, "Select"}};
    std::vector<Hint> out{{{"left"}, "Pick a line; drag up and down: its level"},
                          {{"Ctrl", "wheel"}, "Level"},
                          {{"middle"}, "Orbit"}};
    if (shape->levels.size() > 1)
        out.push_back({{"1", "...", std::to_string(std::min<std::size_t>(9, shape->levels.size()))},
                       "Choose level"});
    return out;
}

} // namespace trivar
