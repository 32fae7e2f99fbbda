// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/silhouettes/silhouettes.h"

#include "editor/hands/level_under.h"
#include "editor/hands/select.h"
#include "editor/session/scene_names.h"
#include "editor/session/volume_levels.h"
#include "ui/icons.h"
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

const char* SilhouettesTool::icon() const
{
    return ui::icon::silhouettes;
}

void SilhouettesTool::begin(Session& session)
{
    const Id id = volume_at_work(session.document(), session.selected);
    if (id != 0 && session.selected != id) session.selected = id;
}

bool SilhouettesTool::takes_wheel() const
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
    if (drag_) return drag(session, input, plateaus);
    turn_wheel(session, input);
    if (wheel_) return;
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
    drag_ = Drag{at_work, chosen, shape->levels[static_cast<std::size_t>(chosen)].value, 0,
                 input.mouse};
}

bool SilhouettesTool::propose_value(Session& session, Id object, int level, double value) const
{
    const VoxelShape* now = volume_of(session.document(), object);
    if (!now || level >= static_cast<int>(now->levels.size())) return false;
    SetVoxels set{object, *now};
    set.shape.levels[static_cast<std::size_t>(level)].value = value;
    return session.propose(set);
}

void SilhouettesTool::drag(Session& session, const ViewportInput& input,
                           std::span<const double> plateaus)
{
    Drag& d = *drag_;
    const VolumeSummary* summary = summary_at(session, d.object);
    const double step = d.last.y - input.mouse.y; // upward raises the value
    d.last = input.mouse;
    const double fine = ImGui::GetIO().KeyShift ? 0.1 : 1;
    d.shift_px += step * fine;
    d.moved = d.moved || std::abs(d.shift_px) > click_slip_px * input.scale;
    if (d.moved && summary && step != 0) {
        const double range = summary->greatest - summary->least;
        const double per_px = range / (drag_range_px * input.scale);
        const double by_hand = d.from_value + d.shift_px * per_px;
        const double reach =
            ImGui::GetIO().KeyCtrl ? 0 : halt_reach_px * input.scale * fine * per_px;
        const double value = ui::snapped(plateaus, by_hand, reach);
        d.halted = std::ranges::find(plateaus, value) != plateaus.end();
        propose_value(session, d.object, d.level, readable_value(value, *summary));
    }
    if (input.released || !input.down) finish(session);
}

void SilhouettesTool::turn_wheel(Session& session, const ViewportInput& input)
{
    if (wheel_ && !ImGui::GetIO().KeyCtrl) return finish(session);
    if (!takes_wheel() || !input.hovered || input.wheel == 0) return;
    const Id id = volume_at_work(session.document(), session.selected);
    const VoxelShape* shape = volume_of(session.document(), id);
    const VolumeSummary* summary = summary_at(session, id);
    if (!shape || !summary) return;
    const int chosen = chosen_in(*shape, id, session.level);
    if (!wheel_) wheel_ = Drag{id, chosen, shape->levels[static_cast<std::size_t>(chosen)].value};
    wheel_->shift_px += input.wheel;
    const double range = summary->greatest - summary->least;
    propose_value(
        session, id, wheel_->level,
        readable_value(wheel_->from_value + wheel_->shift_px * range / wheel_steps, *summary));
}

// One step for all of it; none where the value came back.
void SilhouettesTool::finish(Session& session)
{
    const Drag done = drag_ ? *drag_ : *wheel_;
    drag_.reset();
    wheel_.reset();
    if (!session.proposing()) return;
    const VoxelShape* before = volume_of(session.committed(), done.object);
    const VoxelShape* now = volume_of(session.document(), done.object);
    if (before && now && *before == *now)
        session.cancel();
    else
        session.commit();
}

void SilhouettesTool::take_keys(Session& session)
{
    if (ui::struck({ui::key_enter}) || ui::struck({ui::key_keypad_enter})) finish(session);
}

void SilhouettesTool::cancel(Session& session)
{
    if (!busy()) return;
    drag_.reset();
    wheel_.reset();
    session.cancel();
}

std::vector<Hint> SilhouettesTool::hints(const Session& session) const
{
    if (drag_)
        return {{{"left"}, "Up and down: the level"},
                {{"Shift"}, "Finer"},
                {{"Ctrl"}, "Halts nowhere"},
                {{"Esc"}, "Cancel"}};
    if (wheel_) return {{{"Ctrl"}, "Let go when done"}, {{"Esc"}, "Cancel"}};
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
