// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/tiles.h"

#include "core/base/rounded.h"
#include "core/commands/tiles/mix_tiles.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

// The brush as a ring that lies on the surface.
void paint_ring(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                const glm::dvec3& center, const glm::dvec3& normal, double radius)
{
    const glm::dvec3 other = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(other - glm::dot(other, normal) * normal),
                     y = glm::cross(normal, x);
    constexpr int pieces = 64;
    std::vector<glm::vec2> ring;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = glm::two_pi<double>() * i / pieces;
        const PicturePoint at =
            project(camera, center + radius * (std::cos(angle) * x + std::sin(angle) * y));
        if (at.depth_world <= 0) return;
        ring.push_back(input.rect.lo + glm::vec2(at.p_px));
    }
    ui::paint_path(ring, theme.color.halo, theme.line(3.5f));
    ui::paint_path(ring, theme.color.stroke, theme.line(1.6f));
    const PicturePoint foot = project(camera, center),
                       tip = project(camera, center + 0.5 * radius * normal);
    if (tip.depth_world > 0)
        ui::paint_path({input.rect.lo + glm::vec2(foot.p_px), input.rect.lo + glm::vec2(tip.p_px)},
                       theme.color.stroke, theme.line(1.6f));
}

// Where tiles head to.
void paint_cross(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                 const glm::dvec3& p_world)
{
    const PicturePoint at = project(camera, p_world);
    if (at.depth_world <= 0) return;
    const glm::vec2 p = input.rect.lo + glm::vec2(at.p_px);
    const float arm = theme.px(7);
    for (const auto& [color, width] :
         {std::pair(theme.color.halo, 3.5f), {theme.color.stroke, 1.6f}}) {
        ui::paint_path({p - glm::vec2(arm, 0), p + glm::vec2(arm, 0)}, color, theme.line(width));
        ui::paint_path({p - glm::vec2(0, arm), p + glm::vec2(0, arm)}, color, theme.line(width));
    }
}

} // namespace

bool TilesTool::lays() const
{
    return covers_ || lays_tiles(settings_.brush);
}

ToolState TilesTool::state() const
{
    const bool busy = gesture_ || hand_.motion() || strands_.hand().busy();
    return {.busy = busy, .crosshair = hit_ || busy, .takes_wheel = gesture_.has_value()};
}

Id TilesTool::tile(const Session& session) const
{
    const Id selected = session.selected;
    const auto found = session.document().objects.find(selected);
    if (found == session.document().objects.end()) return 0;
    const Object& o = *found->second;
    return !kind_of(o).has_surface || o.stroke || locked(session.document(), selected) ? 0
                                                                                       : selected;
}

bool TilesTool::begins_layer(const Session& session) const
{
    return !files_.empty() && session.selected == 0;
}

void TilesTool::take_read(Session& session, const TileFile& model)
{
    reading_ = false;
    if (mixing_ != 0) return mix(session, std::exchange(mixing_, 0), model);
    if (gesture_) gesture_->files.push_back(model);
}

void TilesTool::take_back_files(const Session& session)
{
    if (!begun_ || session.document().objects.contains(begun_->layer)) return;
    if (session.selected == 0 && files_.empty()) {
        files_ = begun_->files;
        overlap_ = begun_->overlap;
    }
    begun_.reset();
}

void TilesTool::mix(Session& session, Id layer, const TileFile& other)
{
    if (!is_tile_layer(session.document(), layer)) return;
    const Tiling& tiling = *object(session.document(), layer).tiles;
    session.run(MixTiles{layer, tiling.weight, tiling.others, {other}});
    session.selected = layer;
}

std::vector<std::string> TilesTool::chosen_models(const Session& session) const
{
    if (begins_layer(session)) return files_;
    std::vector<std::string> files;
    const auto add = [&](Id id) {
        if (const auto* file = made_of<ImportedFile>(session.document(), id))
            files.push_back(file->path);
    };
    const Id id = tile(session);
    if (id == 0) return files;
    add(id);
    if (const Object& o = object(session.document(), id); o.tiles)
        for (const MixedTile& each : o.tiles->others) add(each.object);
    return files;
}

void TilesTool::choose_model(Session& session, const std::string& file, bool also)
{
    reading_ = false;
    const Id layer = tile(session);
    if (also && is_tile_layer(session.document(), layer)) {
        mixing_ = layer;
        wanted_ = {file};
        return;
    }
    session.selected = {};
    overlap_ = 0;
    if (!also) files_.clear();
    if (std::erase(files_, file) == 0 || files_.empty()) files_.push_back(file);
}

void TilesTool::fit_model(const TileFit& fit)
{
    overlap_ = fit.overlap;
    if (fit.strand)
        choose_brush(TileBrush::strand);
    else if (lays_strands())
        choose_brush(TileBrush::scatter);
}

std::optional<std::string> TilesTool::take_wanted()
{
    if (wanted_.empty() || reading_) return {};
    const std::string next = wanted_.front();
    wanted_.erase(wanted_.begin());
    reading_ = true;
    return next;
}

Id TilesTool::base_under(const Session& session, const ViewportInput& input) const
{
    const bool fresh = begins_layer(session);
    const Id layer = fresh ? 0 : tile(session);
    if (layer == 0 && !fresh) return 0;
    if (!fresh)
        if (const Object& o = object(session.document(), layer); o.tiles && o.tiles->base != 0)
            return o.tiles->base;
    if (!lays() || !input.seen_at) return 0;
    Id seen = input.seen_at(input.mouse);
    const auto found = session.document().objects.find(seen);
    // Over tiles the brush paints on what these are on.
    if (found != session.document().objects.end() && found->second->tiles)
        seen = found->second->tiles->base;
    return layer != 0 && seen == layer ? 0 : seen;
}

void TilesTool::find_place(const Session& session, const ViewportInput& input)
{
    hit_.reset();
    under_ = 0;
    if (!input.hovered && !input.pressed) return;
    under_ = base_under(session, input);
    if (under_ != 0)
        hit_ = surface_.hit(session, under_, ray_through(session.view.camera, input.mouse));
}

double TilesTool::radius(const Session& session) const
{
    if (radius_ > 0) return radius_;
    const auto found = session.evaluated().objects.find(gesture_ ? gesture_->base : under_);
    if (found == session.evaluated().objects.end()) return 0.1;
    const glm::dvec3 extent = found->second->bounds->size();
    return rounded(std::max(1e-6, 0.08 * std::max({extent.x, extent.y, extent.z})), 2);
}

double TilesTool::size(const Session& session) const
{
    return size_ > 0 ? size_ : rounded(radius(session) / 2, 2);
}

void TilesTool::use(Session& session, const ViewportInput& input)
{
    if (gesture_) return go_on(session, input);
    take_back_files(session);
    const Id strands_of = lays_strands() && !begins_layer(session) ? tile(session) : 0;
    if (strands_.use(session, input, surface_, strands_of)) return hit_.reset();
    if (uses_hand(session)) return use_hand(session, input);
    hand_.let_go();
    find_place(session, input);
    if (!input.pressed || session.committing() || picks_point(input)) return;
    if (hit_)
        begin(session, input);
    else if (const Id layer = begins_layer(session) ? 0 : tile(session);
             layer == 0 || input.under == layer || input.under == 0)
        select_by_click(session, input.under);
    else
        session.notices.say(ui::NoticeKind::warning, "There are no tiles to change yet",
                            "Choose Scatter, Line or Fill to paint some.", of_a_step);
}

void TilesTool::cancel(Session& session)
{
    strands_.cancel(session);
    if (hand_.motion()) {
        hand_.drop();
        return session.cancel();
    }
    if (!gesture_) return;
    gesture_.reset();
    wanted_.clear();
    reading_ = false;
    session.cancel();
}

bool TilesTool::resize(Session& session, double factor)
{
    radius_ = rounded(radius(session) * factor, 3);
    return true;
}

void TilesTool::overlay(const Session& session, const ui::Theme& theme,
                        const ViewportInput& input) const
{
    if (uses_hand(session)) return hand_overlay(session, theme, input);
    if (point_ && settings_.heading == TileHeading::to_point && lays() && !covers_)
        paint_cross(theme, input, session.view.camera, point_->p_world);
    strands_.overlay(session, theme, input);
    if (!hit_) return;
    const bool one = covers_ || settings_.brush == TileBrush::line ||
                     settings_.brush == TileBrush::grab || lays_strands();
    if (!gesture_ && ImGui::GetIO().KeyShift && joins_last_stroke())
        ui::paint_path(
            {input.rect.lo + glm::vec2(project(session.view.camera, last_end_->at.p_world).p_px),
             input.rect.lo + glm::vec2(input.mouse)},
            theme.color.stroke, theme.line(1.6f));
    paint_ring(theme, input, session.view.camera, hit_->p_world, hit_->normal_world,
               one ? size(session) / 2 : radius(session));
    if (!gesture_) return;
    const Id layer = gesture_->layer != 0 ? gesture_->layer : session.committed().next_id;
    const auto shown = session.evaluated().objects.find(layer);
    if (shown == session.evaluated().objects.end() || shown->second->notices.empty()) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
                   {shown->second->notices.front(), theme.color.warn});
}

std::vector<Hint> TilesTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{"left"}, "Let go when done"},
                {{"wheel"}, "Radius"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (const Handles& hand = strands_.hand(); hand.busy() || hand.hovers()) return hand.hints();
    if (tile(session) == 0 && !begins_layer(session))
        return {{{}, "Choose a tile, or select an object to paint with"},
                {{"left"}, "Select"},
                {{"Esc"}, "Select"}};
    if (hand_.motion())
        return {{{"left"}, "Done"},
                {{"Ctrl"}, "Snap"},
                {{"Shift"}, "Fine"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (uses_hand(session))
        return {{{"left"}, "Take a tile, drag to move it"},
                {{"Shift", "left"}, "Several"},
                {{"Ctrl", "left"}, "All of its kind"},
                {{"@Move", "@Rotate", "@Scale"}, "Move, turn, scale"},
                {{"@Delete"}, "Remove"},
                {{"Esc"}, "Select"}};
    if (picking_) return {{{"left"}, "Click the point that tiles head to"}, {{"Esc"}, "Select"}};
    if (covers_)
        return {{{"left"}, "Click a body to cover it"},
                {{"Ctrl", "left"}, "Take the cover away"},
                {{"Esc"}, "Select"}};
    if (settings_.brush == TileBrush::fill)
        return {{{"left"}, "Click an area to fill"}, {{"Esc"}, "Select"}};
    return {{{"left"}, lays() ? "Drag over a surface to paint" : "Drag"},
            {{"Ctrl", "left"}, lays() ? "Erase" : "Opposite"},
            {{"Shift", "left"}, "Straight"},
            {{"@Smaller tool", "@Larger tool"}, "Radius"},
            {{"middle"}, "Orbit"},
            {{"Esc"}, "Select"}};
}

} // namespace trivar
