// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/split_handles.h"

#include "editor/hands/arrow_head.h"
#include "editor/hands/handle_drag.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// The selected object, if it is the only one, visible and not locked; else null.
const EvaluatedObject* handled(const Session& session)
{
    if (session.selected.size() != 1 || locked(session.document(), session.selected))
        return nullptr;
    const auto shown = session.evaluated().objects.find(session.selected);
    if (shown == session.evaluated().objects.end() ||
        !session.document().objects.contains(session.selected))
        return nullptr;
    return shown->second.get();
}

std::vector<SplitHoldPoint> holds_of(const Session& session, SplitHandlesOf of)
{
    const EvaluatedObject* shown = handled(session);
    if (!shown) return {};
    const Object& own = object(session.document(), shown->id);
    if (of == SplitHandlesOf::openings)
        return own.splitting ? split_holds(session.document(), *shown)
                             : std::vector<SplitHoldPoint>{};
    return own.cutting ? cut_holds(*own.cutting, *shown) : std::vector<SplitHoldPoint>{};
}

ui::Color color_of(const ui::Theme& theme, SplitHoldKind kind)
{
    const ui::Palette& c = theme.color;
    switch (kind) {
    case SplitHoldKind::clearance: return c.lattice;
    case SplitHoldKind::reach:
    case SplitHoldKind::gap: return c.free_node;
    default: return c.stroke;
    }
}

bool is_arrow(SplitHoldKind kind)
{
    return kind == SplitHoldKind::reach || kind == SplitHoldKind::gap;
}

const char* drag_words(SplitHoldKind kind)
{
    switch (kind) {
    case SplitHoldKind::none: return "";
    case SplitHoldKind::place: return "Drag to move the obstacle";
    case SplitHoldKind::reach: return "Drag to let the opening reach further";
    case SplitHoldKind::clearance: return "Drag to leave more room round the obstacle";
    case SplitHoldKind::level: return "Drag to move the cut";
    case SplitHoldKind::gap: return "Drag to move both parts apart";
    }
    return "";
}

} // namespace

bool SplitHandles::use(Session& session, const ViewportInput& input, SplitHandlesOf of)
{
    at_px_ = input.mouse;
    if (!drag_) {
        hovered_ = {};
        if (!input.hovered && !input.pressed) return false;
        const auto over =
            hold_at(holds_of(session, of), session.view.camera, input.mouse, input.scale);
        if (!over || session.committing()) return false;
        hovered_ = over->hold;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (!input.pressed) return true;
        session.cancel(); // what was only shown
        const EvaluatedObject* shown = handled(session);
        if (!shown) return true;
        const Object& own = object(session.document(), shown->id);
        drag_ = SplitHoldDrag{shown->id,
                              own.splitting.value_or(Splitting{}),
                              own.cutting.value_or(Cutting{}),
                              shown->own_to_world,
                              stands_of(session.document(), over->obstacles),
                              *over,
                              session.view.camera,
                              input.mouse};
        moved_ = false;
        return true;
    }
    follow(drag_, moved_, session, input, [&](const SplitHoldDrag&) { session.commit(); });
    return true;
}

void SplitHandles::cancel(Session& session)
{
    if (!drag_) return;
    drag_.reset();
    session.cancel();
}

void SplitHandles::overlay(const Session& session, const ui::Theme& theme,
                           const ViewportInput& input, SplitHandlesOf of) const
{
    const SplitHold lit = drag_ ? drag_->held.hold : hovered_;
    std::vector<SplitHoldPoint> points = holds_of(session, of);
    // The one in the hand above the others
    std::stable_partition(points.begin(), points.end(),
                          [&](const auto& p) { return p.hold != lit; });
    const auto at = [&](const glm::dvec3& p) {
        return input.rect.lo + glm::vec2(project(session.view.camera, p).p_px);
    };
    // Threads to what sizes are measured from, below all dots
    for (const SplitHoldPoint& point : points)
        if (const auto seen = seen_at(point, session.view.camera, input.scale);
            seen && is_arrow(point.hold.kind)) {
            const glm::vec2 p = input.rect.lo + glm::vec2(*seen), from = at(point.base_world);
            ui::paint_line(from, p, theme.color.halo, theme.line(3));
            ui::paint_line(from, p, color_of(theme, point.hold.kind), theme.line(1.4f));
        }
    for (const SplitHoldPoint& point : points) {
        const auto seen = seen_at(point, session.view.camera, input.scale);
        if (!seen) continue;
        const bool on = point.hold == lit;
        const SplitHoldKind kind = point.hold.kind;
        const glm::vec2 p = input.rect.lo + glm::vec2(*seen);
        const float radius = theme.scale * (on ? 6.5f : 5.0f);
        const ui::Color color = on ? theme.color.selected : color_of(theme, kind);
        if (is_arrow(kind))
            paint_arrow_head(theme, p, p - at(point.base_world), radius, color);
        else
            ui::paint_dot(p, radius, color, theme.color.halo, 1.5f * theme.scale);
    }
    if (points.empty() || points.back().hold != lit) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(at_px_);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
                   {words_of(points.back())});
}

std::vector<Hint> SplitHandles::hints() const
{
    return handle_hints(drag_.has_value(), drag_words(hovered_.kind));
}

} // namespace trivar
