// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/handles.h"

#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

// Finds the handle that has the mouse; among those at one place, the one that is painted last.
const Handle* nearest_handle(const std::vector<Handle>& all, const ViewportInput& input)
{
    const Handle* out = nullptr;
    double nearest = 1e300;
    for (const Handle& each : all) {
        const double away = glm::distance(each.p_px, input.mouse);
        if (away >= each.reach_px * input.scale || away > nearest) continue;
        nearest = away;
        out = &each;
    }
    return out;
}

// Finds a handle as it is now: of several with its key, the one nearest to its former place.
const Handle* same_handle(const std::vector<Handle>& all, const Handle& handle)
{
    const Handle* out = nullptr;
    for (const Handle& each : all)
        if (each.key == handle.key && (!out || glm::distance(each.p_world, handle.p_world) <
                                                   glm::distance(out->p_world, handle.p_world)))
            out = &each;
    return out;
}

Handle without_functions(Handle handle)
{
    handle.take = {};
    return handle;
}

void paint_thread(const ui::Theme& theme, glm::vec2 a, glm::vec2 b, ui::Color color, float width)
{
    ui::paint_line(a, b, theme.color.halo, theme.line(width + 1.6f));
    ui::paint_line(a, b, color, theme.line(width));
}

void paint_arrow(const ui::Theme& theme, glm::vec2 at, glm::vec2 direction, float radius,
                 ui::Color color)
{
    const float length = glm::length(direction);
    const glm::vec2 d = length > 0 ? direction / length : glm::vec2(1, 0), n(-d.y, d.x);
    const glm::vec2 tip = at + d * radius * 1.3f;
    const glm::vec2 a = at - d * radius * 0.8f + n * radius,
                    b = at - d * radius * 0.8f - n * radius;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddTriangleFilled({tip.x, tip.y}, {a.x, a.y}, {b.x, b.y}, color);
    draw.AddTriangle({tip.x, tip.y}, {a.x, a.y}, {b.x, b.y}, theme.color.halo, 1.5f * theme.scale);
}

void paint_handle(const ui::Theme& theme, const ViewportInput& input, const Handle& handle,
                  bool lit)
{
    const glm::vec2 p = input.rect.lo + glm::vec2(handle.p_px), way(handle.way_px);
    const ui::Color halo = theme.color.halo, color = theme.color.*(lit ? handle.lit : handle.color);
    const float radius = theme.scale * (lit ? 6.5f : 5.0f), rim = 1.5f * theme.scale;
    switch (handle.look) {
    case Handle::Look::ring:
        if (lit)
            ui::paint_dot(p, radius, color, halo, rim);
        else
            ui::paint_dot(p, radius, halo, color, 2 * theme.scale);
        break;
    case Handle::Look::bead: // a rim twice as dark, to be seen on what is light
        ui::paint_dot(p, radius + rim, halo);
        ui::paint_dot(p, radius, color, halo, rim);
        break;
    case Handle::Look::dot: ui::paint_dot(p, radius, color, halo, rim); break;
    case Handle::Look::hollow:
        ui::paint_dot(p, radius + theme.scale, halo, halo, rim);
        ui::paint_dot(p, radius, 0, color, 2 * theme.scale);
        break;
    case Handle::Look::arrow: paint_arrow(theme, p, way, radius, color); break;
    case Handle::Look::diamond: ui::paint_diamond(p, radius + rim, color, halo, rim); break;
    case Handle::Look::cross:
        ui::paint_diamond(p, radius + rim, lit ? color : halo, theme.color.*handle.color,
                          2 * theme.scale);
        if (const float length = glm::length(way); lit && length > 0.01f) {
            const glm::vec2 half = way / length * theme.px(15);
            paint_thread(theme, p - half, p + half, theme.color.selected, 2);
        }
        break;
    }
}

} // namespace

bool Handles::use(Session& session, const ViewportInput& input, const std::vector<Handle>& all)
{
    if (drag_) {
        go_on(session, input);
        return true;
    }
    lit_ = {};
    if ((!input.hovered && !input.pressed) || session.committing()) return false;
    const Handle* over = nearest_handle(all, input);
    if (!over) return false;
    lit_ = without_functions(*over);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (input.pressed)
        take(session, input, *over, input.moves.empty() ? input.mouse : input.moves.front().p_px);
    return true;
}

void Handles::take_by_key(Session& session, const ViewportInput& input, const Handle& handle)
{
    take(session, input, handle, input.mouse);
    by_key_ = true;
}

void Handles::take(Session& session, const ViewportInput& input, const Handle& handle,
                   glm::dvec2 at_px)
{
    session.notices.forget(of_a_step);
    session.cancel(); // what was only shown
    HandleDrag drag = handle.take();
    if (!drag.command) return;
    lit_ = without_functions(handle);
    drag_ = std::move(drag);
    move_ = {.camera = session.view.camera, .from_px = at_px, .scale = input.scale};
    moved_ = by_key_ = entered_ = false;
    typed_ = {};
}

void Handles::take_keys()
{
    if (!drag_) return;
    if (lit_.number != Handle::Number::none) typed_.take_letters();
    entered_ = entered_ || ui::struck({ui::key_enter}) || ui::struck({ui::key_keypad_enter});
}

void Handles::go_on(Session& session, const ViewportInput& input)
{
    move_.camera.size_px = session.view.camera.size_px;
    move_.to_px = input.mouse;
    move_.snap = ImGui::GetIO().KeyCtrl;
    move_.typed =
        typed_.value(0, lit_.number == Handle::Number::length ? Measure::length : Measure::plain);
    move_.done = entered_ || (by_key_ ? input.pressed : input.released || !input.down);
    moved_ = moved_ || glm::distance(input.mouse, move_.from_px) > click_slip_px;
    const bool changes = moved_ || move_.typed;
    if (!move_.done) {
        // One proposal at a time: the next waits until the last one can be seen.
        if (changes && session.up_to_date())
            if (const auto command = drag_->command(move_)) session.propose_quietly(*command);
        return;
    }
    const HandleDrag done = *std::exchange(drag_, std::nullopt);
    typed_ = {};
    const std::optional<Command> last = changes ? done.command(move_) : std::nullopt;
    if (!last || !session.propose(*last)) {
        session.cancel();
        if (!changes && done.click) done.click(session);
    } else if (done.commit) {
        done.commit(session);
    } else {
        session.commit();
    }
}

void Handles::cancel(Session& session)
{
    if (!drag_) return;
    drag_.reset();
    typed_ = {};
    session.cancel();
}

std::string Handles::with_typed(const std::string& said) const
{
    if (!typed_.open()) return said;
    const std::string name = said.substr(0, said.find_first_of("0123456789"));
    return name + typed_.words(0, lit_.number == Handle::Number::length ? " m" : " %", said);
}

void Handles::paint(const ui::Theme& theme, const ViewportInput& input, std::vector<Handle> all,
                    float end_x) const
{
    const Handle* const lit = hovers() ? same_handle(all, lit_) : nullptr;
    for (const Handle& each : all) {
        if (each.thread == Handle::Thread::none) continue;
        if (each.thread == Handle::Thread::lit && &each != lit) continue;
        paint_thread(theme, input.rect.lo + glm::vec2(each.base_px),
                     input.rect.lo + glm::vec2(each.p_px), theme.color.*each.color, 1.4f);
    }
    for (const Handle& each : all)
        if (&each != lit) paint_handle(theme, input, each, false);
    if (lit) paint_handle(theme, input, *lit, true);
    const std::string said = lit     ? with_typed(lit->words)
                             : drag_ ? with_typed(lit_.words)
                                     : std::string();
    if (said.empty()) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    glm::vec2 chip = mouse + glm::vec2(theme.px(18), -theme.px(30));
    const float width = ui::text_width(theme.font.small, said) + theme.px(16);
    if (chip.x + width > end_x - theme.px(8)) chip.x = mouse.x - theme.px(18) - width;
    ui::paint_chip(theme, chip, {said});
}

std::vector<Hint> Handles::hints() const
{
    std::vector<Hint> out;
    if (drag_) {
        out.push_back({{"left"}, by_key_ ? "Click when done" : "Let go when done"});
    } else {
        out.push_back({{"left"}, lit_.verb});
        if (lit_.click_verb) out.push_back({{"left"}, lit_.click_verb});
    }
    out.push_back({{"Ctrl"}, lit_.ctrl_verb});
    if (!drag_) return out;
    if (lit_.number != Handle::Number::none) out.push_back({{"0", "...", "9"}, "Type a number"});
    out.push_back({{"Esc", "/", "right"}, "Cancel"});
    return out;
}

} // namespace trivar
