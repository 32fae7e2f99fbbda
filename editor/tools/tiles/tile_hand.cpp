// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/tile_hand.h"

#include "core/base/number_text.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/words/field_words.h"
#include "core/limit/tangent.h"
#include "core/patches/tile_ray.h"
#include "editor/hands/viewport_input.h"
#include "ui/paint.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace trivar {
namespace {

constexpr double turn_step_deg = 15, factor_step = 0.1; // with Ctrl
constexpr double fine_share = 0.1;                      // with Shift

// A set of painted tiles of a layer, and the object of which they are copies.
struct PaintedSet {
    Ref<TileSet> set;
    Id object = 0;
};
std::vector<PaintedSet> painted_sets(const Session& session, Id layer)
{
    std::vector<PaintedSet> out;
    const auto found = session.evaluated().objects.find(layer);
    if (found == session.evaluated().objects.end()) return out;
    const std::vector<Id>& objects = found->second->tile_objects;
    for (const Part& part : found->second->parts)
        if (const auto mesh = static_cast<std::size_t>(part.key.mesh);
            part.tiles && part.key.piece == 0) // the others cover their base
            out.push_back({part.tiles, mesh < objects.size() ? objects[mesh] : layer});
    return out;
}

// The same, each tile once: where it has several meshes, they share its places.
std::vector<PaintedSet> sets_of_places(const Session& session, Id layer)
{
    std::vector<PaintedSet> out;
    for (PaintedSet& each : painted_sets(session, layer))
        if (std::ranges::none_of(
                out, [&](const PaintedSet& other) { return other.set->tiles == each.set->tiles; }))
            out.push_back(std::move(each));
    return out;
}

// Returns the tile as the layer shows it; its place at rest is still to be found.
SeenTile seen(const PlacedTile& tile, Id object)
{
    SeenTile out;
    out.object = object;
    out.patch = tile.patch;
    const TilePoint middle = tile_point(tile.patch, {0.5, 0.5, 0});
    out.p_world = middle.p;
    if (const double length = glm::length(middle.z); length > 0) out.n_world = middle.z / length;
    out.size_world = (glm::length(middle.x) + glm::length(middle.y)) / 2;
    return out;
}

// Finds where a tile stands on its base; false: it is not above it.
bool find_at_rest(SeenTile& tile, const Session& session, Id layer, PaintedSurface& surface)
{
    const auto there = session.document().objects.find(layer);
    if (there == session.document().objects.end() || !there->second->tiles) return false;
    const Ray down{tile.p_world + 0.25 * tile.size_world * tile.n_world, -tile.n_world};
    const auto hit = surface.hit(session, there->second->tiles->base, down);
    if (!hit || glm::distance(hit->p_world, tile.p_world) > tile.size_world) return false;
    tile.at_rest = hit->at_rest;
    return true;
}

} // namespace

std::optional<SeenTile> TileHand::under(const Session& session, Id layer, const Ray& ray,
                                        PaintedSurface& surface)
{
    double nearest = 1e300;
    std::optional<SeenTile> out;
    for (const auto& [set, object] : painted_sets(session, layer))
        if (const auto hit = first_tile(*set, ray.origin, ray.direction, nearest)) {
            nearest = hit->t;
            out = seen((*set->tiles)[hit->tile], object);
        }
    if (out && !find_at_rest(*out, session, layer, surface)) out.reset();
    return out;
}

bool TileHand::holds(const SeenTile& tile) const
{
    return std::ranges::any_of(
        held_, [&](const SeenTile& each) { return each.at_rest.p == tile.at_rest.p; });
}

void TileHand::take(const SeenTile& tile, bool also)
{
    const bool had =
        std::erase_if(held_, [&](const SeenTile& t) { return t.at_rest.p == tile.at_rest.p; }) > 0;
    if (!also) held_.clear();
    if (!also || !had) held_.push_back(tile);
}

void TileHand::take_those(const Session& session, Id layer, PaintedSurface& surface,
                          const std::function<bool(Id object)>& fits)
{
    held_.clear();
    for (const auto& [set, object] : sets_of_places(session, layer)) {
        if (!fits(object)) continue;
        for (const PlacedTile& each : *set->tiles) {
            SeenTile tile = seen(each, object);
            if (held_.size() < most_tile_samples - 1 && find_at_rest(tile, session, layer, surface))
                held_.push_back(tile);
        }
    }
}

void TileHand::take_all(const Session& session, Id layer, PaintedSurface& surface)
{
    take_those(session, layer, surface, [](Id) { return true; });
}

void TileHand::take_same(const Session& session, Id layer, PaintedSurface& surface)
{
    std::set<Id> objects;
    for (const SeenTile& each : held_) objects.insert(each.object);
    take_those(session, layer, surface, [&](Id object) { return objects.contains(object); });
}

void TileHand::follow(const Session& session, Id layer, PaintedSurface& surface)
{
    std::vector<std::pair<double, SeenTile>> nearest(held_.size(), {1e300, SeenTile{}});
    if (!held_.empty())
        for (const auto& [set, object] : sets_of_places(session, layer))
            for (const PlacedTile& each : *set->tiles) {
                const SeenTile tile = seen(each, object);
                for (std::size_t k = 0; k < held_.size(); ++k) {
                    const double away = glm::distance(tile.p_world, held_[k].p_world);
                    if (away <= 0.25 * tile.size_world && away < nearest[k].first)
                        nearest[k] = {away, tile};
                }
            }
    held_.clear();
    for (auto& [away, tile] : nearest)
        if (away < 1e300 && find_at_rest(tile, session, layer, surface)) held_.push_back(tile);
}

void TileHand::begin(MotionKind kind, const Camera& camera, glm::dvec2 mouse_px)
{
    motion_ = kind;
    from_px_ = mouse_px_ = mouse_px;
    turned_deg_ = travelled_px_ = 0;
    factor_ = 1;
    typed_ = {};
    middle_px_ = glm::dvec2(0);
    for (const SeenTile& tile : held_)
        middle_px_ += project(camera, tile.p_world).p_px / static_cast<double>(held_.size());
}

void TileHand::go_on(const Camera& camera, glm::dvec2 mouse_px, Steps held)
{
    const glm::dvec2 before = mouse_px_ - middle_px_, now = mouse_px - middle_px_;
    const double share = held.fine ? fine_share : 1;
    const auto deg = [](const glm::dvec2& v) { return glm::degrees(std::atan2(-v.y, v.x)); };
    if (glm::length(before) > 1 && glm::length(now) > 1) {
        // Seen from behind, tiles turn the other way.
        const bool behind = !held_.empty() &&
                            glm::dot(held_.front().n_world, camera.eye - held_.front().p_world) < 0;
        turned_deg_ += (behind ? -share : share) * std::remainder(deg(now) - deg(before), 360.0);
        factor_ *= std::pow(glm::length(now) / glm::length(before), share);
    }
    travelled_px_ += glm::distance(mouse_px, mouse_px_);
    mouse_px_ = mouse_px;
    steps_ = held;
}

glm::dvec2 TileHand::goal_px(const Camera& camera) const
{
    if (held_.empty()) return mouse_px_;
    return project(camera, held_.front().p_world).p_px + mouse_px_ - from_px_;
}

std::optional<TileStroke> TileHand::stroke(const std::optional<SurfaceHit>& goal) const
{
    const bool begun = travelled_px_ >= click_slip_px || typed_.open();
    if (!motion_ || held_.empty() || !begun) return std::nullopt;
    TileStroke out;
    for (const SeenTile& tile : held_) out.samples.push_back({tile.at_rest});
    if (*motion_ == MotionKind::move) {
        if (!goal) return std::nullopt;
        out.brush = TileBrush::grab;
        out.samples.push_back({goal->at_rest});
        return out;
    }
    const auto in_steps = [&](double value, double step) {
        return steps_.snap ? step * std::round(value / step) : value;
    };
    out.brush = TileBrush::adjust;
    if (*motion_ == MotionKind::rotate)
        out.turn_deg =
            typed_.value(0, Measure::angle).value_or(in_steps(turned_deg_, turn_step_deg));
    else
        out.factor = std::clamp(
            typed_.value(0, Measure::plain).value_or(in_steps(factor_, factor_step)), 0.01, 100.0);
    return out;
}

void TileHand::end(const std::optional<SurfaceHit>& goal)
{
    if (motion_ == MotionKind::move && goal && !held_.empty()) {
        const SeenTile first = held_.front();
        for (SeenTile& tile : held_)
            tile.p_world = goal->p_world + turned_from_to(first.n_world, goal->normal_world,
                                                          tile.p_world - first.p_world);
    }
    motion_.reset();
}

std::string TileHand::amount() const
{
    const std::optional<TileStroke> now = stroke(SurfaceHit{});
    if (!now || *motion_ == MotionKind::move) return {};
    return *motion_ == MotionKind::rotate ? "Turn " + in_degrees(now->turn_deg)
                                          : "Scale × " + number_text(now->factor);
}

void TileHand::paint_rim(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                         const SeenTile& tile, ui::Color color, float width)
{
    constexpr int pieces = 6; // of each side
    constexpr std::array<glm::dvec2, 5> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    std::vector<glm::vec2> rim;
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i <= pieces; ++i) {
            const glm::dvec2 at =
                glm::mix(corners[side], corners[side + 1], static_cast<double>(i) / pieces);
            const PicturePoint there =
                project(camera, tile_point(tile.patch, {at.x, at.y, 0.02 * tile.size_world}).p);
            if (there.depth_world <= 0) return;
            rim.push_back(input.rect.lo + glm::vec2(there.p_px));
        }
    ui::paint_path(rim, theme.color.halo, theme.line(width + 2));
    ui::paint_path(rim, color, theme.line(width));
}

void TileHand::paint(const ui::Theme& theme, const ViewportInput& input, const Camera& camera) const
{
    for (const SeenTile& tile : held_)
        paint_rim(theme, input, camera, tile, theme.color.stroke, 1.6f);
}

} // namespace trivar
