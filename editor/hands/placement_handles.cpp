// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/placement_handles.h"

#include "core/steps/laying/attaching.h"
#include "editor/hands/arrow_head.h"
#include "editor/hands/handle_drag.h"
#include "editor/hands/strip_paint.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

bool wanted(HandleChoice choice, HoldKind kind)
{
    const bool of_stroke =
        kind == HoldKind::stroke || kind == HoldKind::start || kind == HoldKind::end;
    return choice == HandleChoice::all || (choice == HandleChoice::stroke && of_stroke) ||
           (choice == HandleChoice::sizes && !of_stroke);
}

ui::Color color_of(const ui::Theme& theme, HoldKind kind)
{
    const ui::Palette& c = theme.color;
    switch (kind) {
    case HoldKind::width: return c.free_node;
    case HoldKind::height:
    case HoldKind::across:
    case HoldKind::map: return c.lattice;
    case HoldKind::rise:
    case HoldKind::contact:
    case HoldKind::sunk: return c.contact;
    default: return c.stroke;
    }
}

const char* drag_words(HoldKind kind)
{
    switch (kind) {
    case HoldKind::none: return "";
    case HoldKind::stroke: return "Drag to bend the stroke";
    case HoldKind::width: return "Drag to widen";
    case HoldKind::height:
    case HoldKind::across:
    case HoldKind::map: return "Drag to raise";
    case HoldKind::rise: return "Drag to change the height distribution";
    case HoldKind::start: return "Drag to move the start";
    case HoldKind::end: return "Drag to move the end";
    case HoldKind::contact: return "Drag to lift off the surface";
    case HoldKind::sunk: return "Drag down to sink it in";
    }
    return "";
}

} // namespace

const EvaluatedObject* selected_volume(const Session& session)
{
    if (session.selected.size() != 1) return nullptr;
    if (locked(session.document(), session.selected)) return nullptr;
    const auto found = session.evaluated().objects.find(session.selected);
    if (found == session.evaluated().objects.end() || !found->second->placement) return nullptr;
    const auto there = session.document().objects.find(session.selected);
    if (there == session.document().objects.end()) return nullptr;
    const bool has_volume = kind_of(*there->second).has_cage || there->second->stroke;
    return has_volume ? &*found->second : nullptr;
}

const EvaluatedObject* selected_placement(const Session& session)
{
    const EvaluatedObject* found = selected_volume(session);
    return found && object(session.document(), found->id).stroke ? found : nullptr;
}

bool PlacementHandles::shown(const Session& session) const
{
    return *choice_ != HandleChoice::none && selected_placement(session);
}

std::vector<HoldPoint> PlacementHandles::points(const Session& session) const
{
    const EvaluatedObject* shown = selected_placement(session);
    if (!shown) return {};
    std::vector<HoldPoint> out = hold_points(*object(session.document(), session.selected).stroke,
                                             *shown->stroke_placement());
    std::erase_if(out, [&](const HoldPoint& p) { return !wanted(*choice_, p.hold.kind); });
    return out;
}

bool PlacementHandles::use(Session& session, const ViewportInput& input)
{
    at_px_ = input.mouse;
    if (!drag_) {
        hovered_ = {};
        if (!input.hovered && !input.pressed) return false;
        const auto over = hold_at(points(session), session.view.camera, input.mouse, input.scale);
        if (!over || session.committing()) return false;
        hovered_ = over->hold;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (!input.pressed) return true;
        const EvaluatedObject* laid = selected_placement(session);
        PlacementStep step = *object(session.document(), session.selected).stroke;
        const auto hosts = hosts_now(*laid, step);
        step.sketch = stroke_now(*laid, step);
        drag_ = HoldDrag{session.selected,
                         std::move(step),
                         laid->stroke_placement(),
                         laid->lies_on,
                         *over,
                         session.view.camera,
                         input.mouse,
                         1,
                         stroke_to_world(*laid),
                         hosts};
        moved_ = false;
        return true;
    }
    follow(drag_, moved_, session, input,
           [&](const HoldDrag& done) { session.commit_if_placed(done.object); });
    return true;
}

void PlacementHandles::cancel(Session& session)
{
    if (!drag_) return;
    drag_.reset();
    session.cancel();
}

void PlacementHandles::overlay(const Session& session, const ui::Theme& theme,
                               const ViewportInput& input) const
{
    const EvaluatedObject* laid = selected_placement(session);
    if (!laid || *choice_ == HandleChoice::none) return;
    const Hold lit = drag_ ? drag_->held.hold : hovered_;
    const auto at = [&](const glm::dvec3& p) {
        return input.rect.lo + glm::vec2(project(session.view.camera, p).p_px);
    };
    for (const HoldPoint& point : points(session)) {
        const auto seen = seen_at(point, session.view.camera, input.scale);
        if (!seen) continue;
        const bool on = point.hold == lit;
        const HoldKind kind = point.hold.kind;
        const glm::vec2 p = input.rect.lo + glm::vec2(*seen), from = at(point.base_world);
        const float radius = theme.scale * (on ? 6.5f : 5.0f);
        const ui::Color color = on ? theme.color.selected : color_of(theme, kind);
        const bool sized = kind == HoldKind::width || kind == HoldKind::height ||
                           kind == HoldKind::across || kind == HoldKind::map ||
                           kind == HoldKind::rise;
        const bool stalk = glm::distance(p, at(point.p_world)) > 1;
        if (kind == HoldKind::start || kind == HoldKind::end) {
            paint_arrow_head(theme, p, p - from, radius, color);
            continue;
        }
        // A thread to what its size is measured from, in the hand or where it would look lost.
        if (sized ? on || stalk : stalk) {
            ui::paint_line(from, p, theme.color.halo, theme.line(3));
            ui::paint_line(from, p, color_of(theme, kind), theme.line(1.4f));
        }
        if (kind == HoldKind::sunk && !on) // a ring: the level, not the distance
            ui::paint_dot(p, radius, theme.color.halo, color, 2 * theme.scale);
        else
            ui::paint_dot(p, radius, color, theme.color.halo, 1.5f * theme.scale);
    }
    if (lit.kind == HoldKind::none) return;
    const PlacementParameters& now =
        object(session.document(), session.selected).stroke->parameters;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(at_px_);
    const std::string words = words_of(lit, now, laid->stroke_placement()->report);
    glm::vec2 chip = mouse + glm::vec2(theme.px(18), -theme.px(30));
    const float width = ui::text_width(theme.font.small, words) + theme.px(16);
    if (chip.x + width > strip_legend_at(theme, input.rect).x - theme.px(8)) // it stands there
        chip.x = mouse.x - theme.px(18) - width;
    ui::paint_chip(theme, chip, {words});
}

std::vector<Hint> PlacementHandles::hints() const
{
    return handle_hints(drag_.has_value(), drag_words(hovered_.kind));
}

std::optional<ui::Option> PlacementHandles::option(const Session& session, const ui::Theme& theme)
{
    if (!selected_placement(session)) return std::nullopt;
    return ui::Option{
        "Handles", 224,
        [this, &theme](float width) {
            int chosen = static_cast<int>(*choice_);
            ui::segments(theme, "handles", chosen, {"All", "Stroke", "Sizes", "None"}, width);
            *choice_ = static_cast<HandleChoice>(chosen);
        },
        "Which points of the selected stroke can be dragged in the viewport."};
}

} // namespace trivar
