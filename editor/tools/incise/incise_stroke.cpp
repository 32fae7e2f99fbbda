// SPDX-License-Identifier: GPL-3.0-or-later
// Where strokes of the tool of incisions begin, and which keys it takes.
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/topics.h"
#include "editor/tools/incise/incise.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {

bool InciseTool::awaits(const ui::Chord& chord) const
{
    return chord.key == 'F' && !chord.ctrl && !chord.alt && shown_chosen_.number != 0;
}

// F opens the chosen incision, and Shift F deepens it.
void InciseTool::drag_by_key(Session& session, const ViewportInput& input)
{
    const bool depth = ui::struck({.key = 'F', .shift = true});
    if (!depth && !ui::struck({'F'})) return;
    const auto all = handles(session, input.scale);
    const auto held = std::ranges::find_if(all, [&](const Handle& each) {
        const std::string_view kind = each.key.kind;
        return depth ? kind == "depth" : kind == "left" || kind == "right";
    });
    if (held != all.end()) handles_.take_by_key(session, input, *held);
}

void InciseTool::take_keys(Session&)
{
    handles_.take_keys();
    if (gesture_ && typed_.take_letters()) gesture_->changed = true;
}

void InciseTool::press(Session& session, const ViewportInput& input)
{
    session.notices.forget(of_a_step);
    const glm::dvec2 at_px = input.moves.empty() ? input.mouse : input.moves.front().p_px;
    if (begin_stroke(session, input, at_px, input.under)) return go_on(session, input);
    in_air_ = InAir{input.under, at_px, at_px};
}

// Begins a stroke at a pixel over an object; false: there is nothing that can be cut.
bool InciseTool::begin_stroke(Session& session, const ViewportInput& input, glm::dvec2 at_px,
                              Id under)
{
    const Camera& camera = session.view.camera;
    const Id base = base_of(session, under);
    if (base == 0) return false;
    IncisedSkin skin;
    if (base == session.selected && !skin_.empty()) skin = skin_;
    skin.look(session, base);
    const Ray ray = ray_through(camera, at_px);
    std::optional<SurfaceHit> hit = skin.hit(ray);
    if (!hit) hit = skin.wall_hit(ray);
    if (!hit) hit = skin.shut_hit(ray); // over a wound
    if (!hit) return false;
    const bool redraws = ImGui::GetIO().KeyCtrl && hovered_cut_ != 0 &&
                         hovered_cut_ == session.incision.number && chosen(session);
    IncisionSnaps snaps;
    if (base == session.selected) snaps = snaps_but(redraws ? hovered_cut_ : 0);
    SurfaceHit from = *hit;
    if (const auto end = snap_near(snaps, camera, at_px, input.scale)) {
        from.at_rest = end->at_rest;
        from.p_world = end->p_world;
        forget_place(snaps, *end);
    }
    typed_ = {};
    gesture_.emplace(Gesture{base, under, IncisionStroke(skin, std::move(snaps), from, at_px),
                             base == session.selected ? hovered_cut_ : 0});
    if (redraws) {
        gesture_->redrawn = *chosen(session);
        gesture_->from = hovered_at_;
    }
    return true;
}

// A stroke that begins beside an object begins where it comes to one.
void InciseTool::come_from_air(Session& session, const ViewportInput& input)
{
    constexpr double step_px = 3;
    for (auto move = input.moves.begin(); move != input.moves.end(); ++move) {
        const glm::dvec2 from = std::exchange(in_air_->p_px, move->p_px);
        const bool moved = glm::distance(move->p_px, in_air_->begun_px) > click_slip_px;
        const int steps =
            moved ? static_cast<int>(glm::distance(from, move->p_px) / step_px) + 1 : 0;
        for (int i = 1; i <= steps; ++i) {
            const glm::dvec2 at = glm::mix(from, move->p_px, static_cast<double>(i) / steps);
            hovered_cut_ = 0;
            if (!input.seen_at || !begin_stroke(session, input, at, input.seen_at(at))) continue;
            in_air_.reset();
            ViewportInput rest = input;
            rest.moves.assign(move, input.moves.end());
            return go_on(session, rest);
        }
    }
    if (input.down && !input.released) return;
    const InAir air = *std::exchange(in_air_, std::nullopt);
    if (glm::distance(air.p_px, air.begun_px) > click_slip_px)
        return session.notices.say(ui::NoticeKind::warning, "Nothing is cut",
                                   "The stroke went over nothing that can be cut.", of_a_step);
    session.incision = {};
    select_by_click(session, air.under);
}

} // namespace trivar
