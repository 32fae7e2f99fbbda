// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"
#include "editor/tools/tiles/tiles.h"

#include <imgui.h>

namespace trivar {

bool TilesTool::uses_hand(const Session& session) const
{
    return !covers_ && settings_.brush == TileBrush::grab &&
           is_tile_layer(session.document(), tile(session));
}

bool TilesTool::grab(Session& session, MotionKind kind)
{
    if (!uses_hand(session)) return false;
    if (hand_.held().empty())
        session.notices.say(ui::NoticeKind::warning, "No tile is selected",
                            "Click one, and with Shift more of them. With the Select tool the keys "
                            "move, turn and scale the whole layer.",
                            of_a_step);
    else if (!session.committing())
        asked_ = kind;
    return true;
}

bool TilesTool::choose(Session& session, PartChoice choice)
{
    if (!uses_hand(session)) return false;
    if (choice == PartChoice::all)
        hand_.take_all(session, tile(session), surface_);
    else if (choice == PartChoice::none)
        hand_.let_go();
    else if (choice == PartChoice::same)
        hand_.take_same(session, tile(session), surface_);
    return true;
}

bool TilesTool::remove(Session& session)
{
    if (!uses_hand(session) || hand_.held().empty() || session.committing()) return false;
    const Id layer = tile(session);
    TileStroke gone;
    gone.brush = TileBrush::adjust;
    gone.factor = 0;
    gone.mirror = settings_.mirror;
    for (const SeenTile& each : hand_.held()) gone.samples.push_back({each.at_rest});
    if (session.run(PaintTiles{layer, object(session.document(), layer).tiles->base, gone}))
        hand_.let_go();
    return true;
}

void TilesTool::take_keys(Session&)
{
    if (!hand_.motion()) return;
    hand_.typed().take_letters();
    enter_ = ui::struck({ui::key_enter}) || ui::struck({ui::key_keypad_enter});
}

void TilesTool::use_hand(Session& session, const ViewportInput& input)
{
    const Id layer = tile(session);
    if (std::exchange(hand_layer_, layer) != layer) hand_.let_go();
    hit_.reset();
    if (hand_.motion()) return move_by_hand(session, input);
    if (session.up_to_date() && hand_evaluation_ != session.evaluation()) {
        hand_.follow(session, layer, surface_);
        hand_evaluation_ = session.evaluation();
    }
    const Camera& camera = session.view.camera;
    under_hand_.reset();
    if (input.hovered || input.pressed)
        under_hand_ = TileHand::under(session, layer, ray_through(camera, input.mouse), surface_);
    if (const auto kind = std::exchange(asked_, std::nullopt); kind && !hand_.held().empty()) {
        hand_.begin(*kind, camera, input.mouse);
        by_key_ = true;
        return;
    }
    if (!input.pressed || session.committing()) return;
    const bool also = ImGui::GetIO().KeyShift;
    if (!under_hand_) {
        const Id base = object(session.document(), layer).tiles->base;
        if (input.under != 0 && input.under != layer && input.under != base)
            select_by_click(session, input.under);
        else if (!also)
            hand_.let_go();
        return;
    }
    const bool same = ImGui::GetIO().KeyCtrl;
    if (also || !hand_.holds(*under_hand_)) hand_.take(*under_hand_, also && !same);
    if (same) hand_.take_same(session, layer, surface_);
    if (also || same) return;
    hand_.begin(MotionKind::move, camera, input.mouse);
    by_key_ = false;
}

void TilesTool::move_by_hand(Session& session, const ViewportInput& input)
{
    const Camera& camera = session.view.camera;
    const Id layer = hand_layer_, base = object(session.document(), layer).tiles->base;
    hand_.go_on(camera, input.mouse, {ImGui::GetIO().KeyCtrl, ImGui::GetIO().KeyShift});
    std::optional<SurfaceHit> goal;
    if (hand_.motion() == MotionKind::move)
        goal = surface_.hit(session, base, ray_through(camera, hand_.goal_px(camera)));
    std::optional<TileStroke> stroke = hand_.stroke(goal);
    if (stroke) stroke->mirror = settings_.mirror;
    const bool over =
        by_key_ ? input.pressed || std::exchange(enter_, false) : input.released || !input.down;
    if (!over) {
        if (stroke && session.up_to_date())
            session.propose_quietly(PaintTiles{layer, base, *stroke});
        return;
    }
    if (stroke && session.propose(PaintTiles{layer, base, *stroke})) {
        session.commit();
        hand_.end(goal);
    } else {
        session.cancel();
        hand_.drop();
    }
}

void TilesTool::hand_overlay(const Session& session, const ui::Theme& theme,
                             const ViewportInput& input) const
{
    const Camera& camera = session.view.camera;
    if (!hand_.motion()) {
        hand_.paint(theme, input, camera);
        if (under_hand_ && !hand_.holds(*under_hand_))
            TileHand::paint_rim(theme, input, camera, *under_hand_, theme.color.hovered, 1.2f);
        return;
    }
    if (const std::string amount = hand_.amount(); !amount.empty())
        ui::paint_chip(
            theme, input.rect.lo + glm::vec2(input.mouse) + glm::vec2(theme.px(18), -theme.px(30)),
            {amount, theme.color.text});
}

} // namespace trivar
