// SPDX-License-Identifier: GPL-3.0-or-later
// How the tool of incisions drags handles, by the mouse or by a key, and takes typed numbers.
#include "core/commands/cutting/peel.h"
#include "editor/tools/incise/incise.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// A flap that a hand has laid back leaves no number behind, unless it has keys. Nothing: it lay.
std::optional<Command> without_flat_flap(const Document& before, const Command& command)
{
    const auto* peel = command.as<PeelFlap>();
    if (!peel || peel->flap.lift > 0) return command;
    const Object& of = object(before, peel->object);
    const std::vector<PeeledFlap>& flaps = of.incising->flaps;
    const auto known = std::ranges::find_if(
        flaps, [&](const PeeledFlap& each) { return each.same_place(peel->flap); });
    if (known == flaps.end()) return {};
    const auto index = static_cast<int>(known - flaps.begin());
    const std::string lift = fmt::format("incising.flaps.{}.lift", index);
    if (std::ranges::find(of.tracks, lift, &Track::parameter) != of.tracks.end()) return command;
    return LayFlap{peel->object, index + 1};
}

} // namespace

void InciseTool::begin_drag(const Session& session, const IncisionHoldPoint& held,
                            const ViewportInput& input, glm::dvec2 at_px)
{
    const NamedIncision* one = chosen(session);
    const SeenCut* seen = seen_chosen(session);
    if (!one || !seen) return;
    drag_ = IncisionDrag{session.selected,
                         session.incision.number,
                         *one,
                         *seen,
                         skin_,
                         held,
                         snaps_but(session.incision.number),
                         session.view.camera,
                         at_px,
                         input.scale};
    moved_ = by_key_ = entered_ = false;
    typed_ = {};
}

void InciseTool::begin_crossing_drag(const Session& session, const CrossingHold& held,
                                     const ViewportInput& input, glm::dvec2 at_px)
{
    const int number = session.incision.number;
    const auto other = static_cast<std::size_t>(held.crossing.other_than(number)) - 1;
    const SeenCut* seen = seen_chosen(session);
    if (!seen || other >= cuts_.size() || !cuts_[other]) return;
    crossing_drag_ = CrossingDrag{
        session.selected,    number, known_->cuts[other], *seen, *cuts_[other], skin_, held,
        session.view.camera, at_px,  input.scale};
    moved_ = by_key_ = entered_ = false;
    typed_ = {};
}

bool InciseTool::awaits(const ui::Chord& chord) const
{
    return chord.key == 'F' && !chord.ctrl && !chord.alt && shown_chosen_.number != 0;
}

void InciseTool::drag_by_key(Session& session, const ViewportInput& input)
{
    const bool depth = ui::struck({.key = 'F', .shift = true});
    if (!depth && !ui::struck({'F'})) return;
    const auto is_wanted = [&](const IncisionHoldPoint& each) {
        return depth
                   ? each.hold == IncisionHold::depth
                   : each.hold == IncisionHold::open_right || each.hold == IncisionHold::open_left;
    };
    const auto all = holds(session, input.scale);
    const auto held = std::ranges::find_if(all, is_wanted);
    if (held == all.end()) return;
    begin_drag(session, *held, input, input.mouse);
    by_key_ = true;
}

void InciseTool::take_keys(Session&)
{
    if (!gesture_ && !dragging()) return;
    if (typed_.take_letters() && gesture_) gesture_->changed = true;
    entered_ = entered_ ||
               (dragging() && (ui::struck({ui::key_enter}) || ui::struck({ui::key_keypad_enter})));
}

bool InciseTool::ends_drag(const ViewportInput& input) const
{
    if (entered_) return true;
    return by_key_ ? input.pressed : input.released || !input.down;
}

std::optional<Command> InciseTool::typed_command() const
{
    if (!typed_.open()) return {};
    const bool length =
        drag_ ? types_length(drag_->held.hold) : crossing_drag_->held.flap.has_value();
    const auto number = typed_.value(0, length ? Measure::length : Measure::plain);
    if (!number) return {};
    if (crossing_drag_) return typed_in(*crossing_drag_, *number);
    if (const auto edit = typed_in(*drag_, *number)) return *edit;
    return {};
}

void InciseTool::drag_on(Session& session, const ViewportInput& input)
{
    Camera& camera = drag_ ? drag_->camera : crossing_drag_->camera;
    camera.size_px = session.view.camera.size_px;
    const glm::dvec2 from_px = drag_ ? drag_->from_px : crossing_drag_->from_px;
    moved_ = moved_ || glm::distance(input.mouse, from_px) > click_slip_px;
    const bool snap = ImGui::GetIO().KeyCtrl;
    const std::optional<Command> typed = typed_command();
    const auto command = [&] {
        if (typed) return *typed;
        return crossing_drag_ ? dragged(*crossing_drag_, input.mouse, snap)
                              : Command(dragged(*drag_, input.mouse, snap));
    };
    const bool changes = moved_ || typed;
    if (!ends_drag(input)) {
        // One proposal at a time: the next waits until the last one can be seen.
        if (changes && session.up_to_date()) session.propose_quietly(command());
        return;
    }
    const std::optional<Command> last =
        changes ? without_flat_flap(session.committed(), command()) : std::nullopt;
    const std::optional<CrossingDrag> crossed = std::exchange(crossing_drag_, std::nullopt);
    drag_.reset();
    typed_ = {};
    if (last && session.propose(*last)) {
        session.commit();
        return;
    }
    session.cancel();
    if (last || !crossed || crossed->held.flap) return;
    // A click on a crossing swaps the order of both
    const CutCrossing& crossing = crossed->held.crossing;
    if (session.run(SwapIncisions{crossed->object, crossing.first, crossing.second}))
        session.incision.number = crossing.other_than(crossed->number);
}

std::string InciseTool::typed_words(const std::string& said) const
{
    if (!typed_.open()) return said;
    if (gesture_) return gesture_->redrawn ? said : "Width " + typed_.words(0, " m", said);
    const std::string name = said.substr(0, said.find_first_of("0123456789"));
    const bool length =
        drag_ ? types_length(drag_->held.hold) : crossing_drag_ && crossing_drag_->held.flap;
    return name + typed_.words(0, length ? " m" : " %", said);
}

} // namespace trivar
