// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gesture.h"

#include "editor/hands/tool.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "ui/keys.h"

#include <imgui.h>

namespace trivar {

void Gesture::begin(const ViewportInput& input, bool by_key)
{
    going_ = true;
    by_key_ = by_key;
    moved_ = shown_ = false;
    outside_ = !input.hovered;
    from_px_ = input.mouse;
}

bool Gesture::follow(const ViewportInput& input)
{
    moved_ = moved_ || glm::distance(input.mouse, from_px_) >= click_slip_px;
    outside_ = !input.hovered;
    return by_key_ ? input.pressed : input.released || !input.down;
}

Gesture::State Gesture::go_on(Session& session, const ViewportInput& input, const Wanted& wanted,
                              const Commit& commit)
{
    if (!going_) return State::dropped;
    if (follow(input)) return finish(session, wanted, commit);
    show(session, wanted);
    return State::goes_on;
}

void Gesture::show(Session& session, const Wanted& wanted)
{
    if (!session.up_to_date()) return;
    const std::optional<Command> command = wanted();
    if (command)
        shown_ = session.propose_quietly(*command) || shown_;
    else if (std::exchange(shown_, false))
        session.cancel();
}

Gesture::State Gesture::finish(Session& session, const Wanted& wanted, const Commit& commit)
{
    const std::optional<Command> command = wanted();
    going_ = false;
    if (!command || !session.propose(*command)) {
        session.cancel();
        return State::dropped;
    }
    if (commit)
        commit();
    else
        session.commit();
    return State::done;
}

bool Gesture::take_keys() const
{
    const auto struck = [](int key) { // whatever is held beside it: Ctrl and Shift lead the hand
        return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key, false);
    };
    const bool elsewhere = by_key_ && outside_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    return elsewhere || struck(ui::key_enter) || struck(ui::key_keypad_enter);
}

void Gesture::cancel(Session& session)
{
    if (!going_) return;
    going_ = false;
    session.cancel();
}

} // namespace trivar
