// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/strand_handles.h"

#include "core/tiles/on_surface.h"
#include "editor/hands/viewport_input.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

constexpr double strand_reach_px = 60; // of the mouse, at scale 1: a strand so near is shown
// The distance along the strand over which points go along with the one that is dragged, in sizes
// of its tiles.
constexpr double least_soft = 3;

} // namespace

void StrandHandles::cancel(Session& session)
{
    shown_.clear();
    hand_.cancel(session);
}

void StrandHandles::find(const Session& session, const ViewportInput& input,
                         PaintedSurface& surface, Id layer)
{
    const Tiling& tiling = *object(session.document(), layer).tiles;
    const Camera& camera = session.view.camera;
    double nearest = strand_reach_px * input.scale;
    for (std::size_t k = 0; k < tiling.strokes.size(); ++k) {
        const TileStroke& stroke = *tiling.strokes[k];
        if (stroke.brush != TileBrush::strand || stroke.hidden) continue;
        std::vector<SurfacePoint> at_rest;
        for (const TileSample& each : stroke.samples) at_rest.push_back(each.at);
        const auto seen = surface.seen(session, tiling.base, at_rest, stroke.size);
        std::vector<Handle> points;
        double away = 1e300;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (!seen[i]) continue;
            // Points on the far side cannot be seen.
            if (glm::dot(seen[i]->normal_world, camera.eye - seen[i]->p_world) < 0) continue;
            const PicturePoint at = project(camera, seen[i]->p_world);
            if (at.depth_world <= 0) continue;
            away = std::min(away, glm::distance(at.p_px, input.mouse));
            points.push_back({.key = {"point", {static_cast<int>(k) + 1, static_cast<int>(i)}},
                              .p_world = seen[i]->p_world,
                              .p_px = at.p_px,
                              .look = Handle::Look::bead,
                              .color = &ui::Palette::selected, // light on dark
                              .lit = &ui::Palette::stroke,
                              .verb = "Drag the point of the strand",
                              .ctrl_verb = "This point alone"});
            points.back().take = [=, this, &session] { return drag_of(session, layer, k, i); };
        }
        if (!(away < nearest)) continue;
        nearest = away;
        shown_ = std::move(points);
    }
}

HandleDrag StrandHandles::drag_of(const Session& session, Id layer, std::size_t number,
                                  std::size_t sample)
{
    const TileStroke& stroke = *object(session.document(), layer).tiles->strokes[number];
    drag_ = std::make_shared<StrandDrag>(
        StrandDrag{.layer = layer, .held = sample, .before = stroke, .stroke = stroke});
    return {[drag = drag_, number](const HandMove&) {
        return EditTileStroke{drag->layer, static_cast<int>(number) + 1, drag->stroke};
    }};
}

void StrandHandles::drag_to(const Session& session, const SurfaceHit& hit, PaintedSurface& surface,
                            Id base)
{
    const std::vector<TileSample>& before = drag_->before.samples;
    const std::size_t held = drag_->held;
    const double reach = ImGui::GetIO().KeyCtrl
                             ? 0
                             : std::max(drag_->before.radius, least_soft * drag_->before.size);
    const glm::dvec3 way = hit.at_rest.p - before[held].at.p;
    // Distances of samples from the one in the hand, along the stroke
    std::vector<double> away(before.size(), 0);
    for (std::size_t i = held; i-- > 0;)
        away[i] = away[i + 1] + glm::distance(before[i].at.p, before[i + 1].at.p);
    for (std::size_t i = held + 1; i < before.size(); ++i)
        away[i] = away[i - 1] + glm::distance(before[i].at.p, before[i - 1].at.p);
    std::vector<SurfacePoint> wanted;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double share = reach > 0 ? brush_share(away[i], reach) : 0;
        wanted.push_back({before[i].at.p + share * way, before[i].at.normal});
    }
    const auto seen = surface.seen(session, base, wanted, glm::length(way) + drag_->before.size);
    std::vector<TileSample> samples = before;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (seen[i] && wanted[i] != before[i].at) samples[i].at = seen[i]->at_rest;
    samples[held].at = hit.at_rest;
    drag_->stroke.samples = std::move(samples);
    for (Handle& each : shown_) {
        const auto sample = static_cast<std::size_t>(each.key.numbers[1]);
        if (sample == held)
            each.p_world = hit.p_world;
        else if (seen[sample])
            each.p_world = seen[sample]->p_world;
    }
}

bool StrandHandles::use(Session& session, const ViewportInput& input, PaintedSurface& surface,
                        Id layer)
{
    if (!hand_.busy()) {
        shown_.clear();
        if (layer != 0 && (input.hovered || input.pressed) &&
            object(session.document(), layer).tiles)
            find(session, input, surface, layer);
        return hand_.use(session, input, shown_);
    }
    const auto there = session.document().objects.find(drag_->layer);
    if (there == session.document().objects.end() || !there->second->tiles) {
        hand_.cancel(session);
        return true;
    }
    const Id base = there->second->tiles->base;
    drag_->moved = drag_->moved || glm::distance(input.mouse, hand_.from_px()) > click_slip_px;
    if (!drag_->moved) return hand_.use(session, input, shown_);
    if (const auto hit = surface.hit(session, base, ray_through(session.view.camera, input.mouse)))
        drag_to(session, *hit, surface, base);
    return hand_.use(session, input, shown_);
}

void StrandHandles::overlay(const Session& session, const ui::Theme& theme,
                            const ViewportInput& input) const
{
    std::vector<Handle> now;
    std::vector<glm::vec2> line;
    for (const Handle& each : shown_) {
        const PicturePoint at = project(session.view.camera, each.p_world);
        if (at.depth_world <= 0) continue;
        now.push_back(each);
        now.back().p_px = at.p_px;
        line.push_back(input.rect.lo + glm::vec2(at.p_px));
    }
    if (line.size() == shown_.size() && line.size() > 1) {
        ui::paint_path(line, theme.color.halo, theme.line(3.5f));
        ui::paint_path(line, theme.color.stroke, theme.line(1.4f));
    }
    hand_.paint(theme, input, std::move(now));
}

} // namespace trivar
