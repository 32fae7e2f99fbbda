// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/strand_handles.h"

#include "core/tiles/on_surface.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// A point is under the mouse, or its strand is shown, if it is as near; pixels at scale 1.
constexpr double strand_point_px = 9, strand_reach_px = 60;
// How far along the strand points go along with the one that is dragged, in sizes of its tiles.
constexpr double least_soft = 3;

} // namespace

void StrandHandles::forget()
{
    hovered_.reset();
    shown_.clear();
}

void StrandHandles::cancel(Session& session)
{
    forget();
    if (!drag_) return;
    drag_.reset();
    session.cancel();
}

void StrandHandles::find(const Session& session, const ViewportInput& input,
                         PaintedSurface& surface, Id layer)
{
    forget();
    const Tiling& tiling = *object(session.document(), layer).tiles;
    const Camera& camera = session.view.camera;
    double nearest = strand_reach_px * input.scale, nearest_point = strand_point_px * input.scale;
    for (std::size_t k = 0; k < tiling.strokes.size(); ++k) {
        const TileStroke& stroke = *tiling.strokes[k];
        if (stroke.brush != TileBrush::strand || stroke.hidden) continue;
        std::vector<SurfacePoint> at_rest;
        for (const TileSample& each : stroke.samples) at_rest.push_back(each.at);
        const auto seen = surface.seen(session, tiling.base, at_rest, stroke.size);
        std::vector<std::pair<StrandHold, glm::dvec3>> points;
        double away = 1e300;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (!seen[i]) continue;
            // Points on the far side cannot be seen.
            if (glm::dot(seen[i]->normal_world, camera.eye - seen[i]->p_world) < 0) continue;
            points.push_back({{k, i}, seen[i]->p_world});
            const PicturePoint at = project(camera, seen[i]->p_world);
            if (at.depth_world > 0) away = std::min(away, glm::distance(at.p_px, input.mouse));
        }
        if (!(away < nearest)) continue;
        nearest = away;
        shown_ = std::move(points);
    }
    for (const auto& [hold, p_world] : shown_) {
        const double away = glm::distance(project(camera, p_world).p_px, input.mouse);
        if (away < nearest_point) nearest_point = away, hovered_ = hold;
    }
}

void StrandHandles::drag_to(const Session& session, const SurfaceHit& hit, PaintedSurface& surface,
                            Id base)
{
    const std::vector<TileSample>& before = drag_->before.samples;
    const std::size_t held = drag_->held.sample;
    const double reach = ImGui::GetIO().KeyCtrl
                             ? 0
                             : std::max(drag_->before.radius, least_soft * drag_->before.size);
    const glm::dvec3 way = hit.at_rest.p - before[held].at.p;
    // How far samples are from the one in the hand, along the stroke.
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
    drag_->proposed = drag_->proposed && samples == drag_->stroke.samples;
    drag_->stroke.samples = std::move(samples);
    for (auto& [hold, p_world] : shown_)
        if (hold == drag_->held)
            p_world = hit.p_world;
        else if (seen[hold.sample])
            p_world = seen[hold.sample]->p_world;
}

bool StrandHandles::use(Session& session, const ViewportInput& input, PaintedSurface& surface,
                        Id layer)
{
    if (!drag_) {
        forget();
        if (layer == 0 || (!input.hovered && !input.pressed)) return false;
        if (!object(session.document(), layer).tiles) return false;
        find(session, input, surface, layer);
        if (!hovered_ || session.committing()) return false;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (!input.pressed) return true;
        const Tiling& tiling = *object(session.document(), layer).tiles;
        const TileStroke& stroke = *tiling.strokes[hovered_->stroke];
        drag_ = StrandDrag{layer, *hovered_, stroke, stroke};
        drag_->from_px = input.mouse;
        return true;
    }
    const auto number = static_cast<int>(drag_->held.stroke) + 1;
    drag_->moved = drag_->moved || glm::distance(input.mouse, drag_->from_px) > click_slip_px;
    const auto there = session.document().objects.find(drag_->layer);
    if (there == session.document().objects.end() || !there->second->tiles) {
        drag_.reset();
        return true;
    }
    if (drag_->moved)
        if (const auto hit = surface.hit(session, there->second->tiles->base,
                                         ray_through(session.view.camera, input.mouse)))
            drag_to(session, *hit, surface, there->second->tiles->base);
    const auto edit = [&] { return EditTileStroke{drag_->layer, number, drag_->stroke}; };
    if (input.released || !input.down) {
        const EditTileStroke last = edit();
        const bool moved = drag_->moved;
        drag_.reset();
        if (moved && session.propose(last))
            session.commit();
        else
            session.cancel();
    } else if (!drag_->proposed && session.up_to_date()) {
        // One proposal at a time: the next waits until the last one can be seen.
        drag_->proposed = session.propose_quietly(edit());
    }
    return true;
}

void StrandHandles::overlay(const Session& session, const ui::Theme& theme,
                            const ViewportInput& input) const
{
    std::vector<glm::vec2> line;
    for (const auto& [hold, p_world] : shown_) {
        const PicturePoint at = project(session.view.camera, p_world);
        if (at.depth_world > 0) line.push_back(input.rect.lo + glm::vec2(at.p_px));
    }
    if (line.size() == shown_.size() && line.size() > 1) {
        ui::paint_path(line, theme.color.halo, theme.line(3.5f));
        ui::paint_path(line, theme.color.stroke, theme.line(1.4f));
    }
    for (const auto& [hold, p_world] : shown_) {
        const PicturePoint at = project(session.view.camera, p_world);
        if (at.depth_world <= 0) continue;
        const bool on = (hovered_ && *hovered_ == hold) || (drag_ && drag_->held == hold);
        // Light on dark, so that they are seen on gold as well as on what is pale or dark.
        const glm::vec2 p = input.rect.lo + glm::vec2(at.p_px);
        const float radius = theme.scale * (on ? 6.5f : 4.5f);
        for (const float rim : {2.2f, 1.4f}) // twice as dark as one
            ui::paint_dot(p, radius + rim * theme.scale, theme.color.halo, 0, 0);
        ui::paint_dot(p, radius, on ? theme.color.stroke : theme.color.selected, 0, 0);
    }
}

} // namespace trivar
