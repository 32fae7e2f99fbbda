// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounded.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"
#include "editor/tools/tiles/tiles.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

// The distance between samples, in sizes of a tile; those of strands are few, and so easy to move.
constexpr double sample_step = 0.25, strand_step = 1;

// Whether a fill may be dragged over more of what it fills.
bool takes_several(TileArea area)
{
    return area == TileArea::material || area == TileArea::faces;
}

} // namespace

void TilesTool::begin(Session& session, const ViewportInput& input)
{
    const bool fresh = begins_layer(session);
    Gesture g{fresh ? 0 : tile(session), under_, settings_};
    if (fresh) wanted_ = files_;
    if (fresh) g.overlap = overlap_;
    mixing_ = 0;
    g.stroke.radius = radius(session) / hit_->scale;
    g.stroke.size = size(session) / hit_->scale;
    g.stroke.seed = ++strokes_;
    // Settings that this brush does not use keep their defaults.
    const TileStroke usual;
    if (g.stroke.brush == TileBrush::color) g.stroke.color = color_;
    if (g.stroke.brush != TileBrush::fill) g.stroke.area = usual.area;
    g.stroke.mirrors_tiles = lays_tiles(g.stroke.brush) && g.stroke.brush != TileBrush::strand &&
                             g.stroke.mirror != TileMirror::none;
    if (g.stroke.heading == TileHeading::to_point && point_ && point_->base == g.base)
        g.stroke.point = point_->p_rest;
    g.joins = ImGui::GetIO().KeyShift && joins_last_stroke();
    if (covers_) {
        g.cover = cover_;
        g.cover->size = g.stroke.size;
        if (ImGui::GetIO().KeyCtrl) g.cover->pattern = TilePattern::none;
    } else if (ImGui::GetIO().KeyCtrl) { // the opposite of what the brush does
        if (lays_tiles(g.stroke.brush))
            g.stroke.brush = TileBrush::erase;
        else
            g.stroke.strength = -g.stroke.strength;
    }
    g.begun_px = g.last_px = input.mouse;
    gesture_ = std::move(g);
    add(*hit_, 0, 1);
    session.notices.forget(of_a_step);
    if (settings_.brush == TileBrush::morph && !covers_ && !fresh &&
        object(session.document(), gesture_->layer).tiles &&
        object(session.document(), gesture_->layer).tiles->into == 0)
        session.notices.say(ui::NoticeKind::warning, "The tiles have nothing to become yet",
                            "Select another object, then the layer, and use Morph tiles.",
                            of_a_step);
    go_on(session, input);
}

void TilesTool::add(const SurfaceHit& hit, double time_s, double pressure)
{
    std::vector<TileSample>& samples = gesture_->stroke.samples;
    if (samples.size() >= most_tile_samples) return;
    if (gesture_->stroke.brush == TileBrush::grab && samples.size() == 2) {
        samples.back() = {hit.at_rest, time_s, 1};
        ++gesture_->moves;
        return;
    }
    const bool strand = gesture_->stroke.brush == TileBrush::strand;
    if (strand && samples.size() > 1 &&
        glm::distance(samples.back().at.p, samples[samples.size() - 2].at.p) <
            strand_step * gesture_->stroke.size) {
        // The last sample goes with the mouse until it is far enough from the one before.
        samples.back() = {hit.at_rest, time_s, std::clamp(pressure, 0.0, 1.0)};
        ++gesture_->moves;
        return;
    }
    const double step = sample_step * std::min(gesture_->stroke.size, gesture_->stroke.radius);
    if (!samples.empty() && glm::distance(samples.back().at.p, hit.at_rest.p) < step) return;
    samples.push_back({hit.at_rest, time_s, std::clamp(pressure, 0.0, 1.0)});
}

void TilesTool::straighten(Session& session, glm::dvec2 from_px, const StrokeSample& to)
{
    constexpr double step_px = 4, most_steps = 1000;
    Gesture& g = *gesture_;
    if (g.stroke.samples.empty()) return;
    const TileSample first = g.stroke.samples.front();
    g.stroke.samples = {first};
    ++g.moves;
    const double steps =
        std::clamp(std::ceil(glm::distance(from_px, to.p_px) / step_px), 1.0, most_steps);
    for (double i = 1; i <= steps; ++i) {
        const glm::dvec2 p_px = glm::mix(from_px, to.p_px, i / steps);
        const auto hit = surface_.hit(session, g.base, ray_through(session.view.camera, p_px));
        if (!hit) continue;
        hit_ = hit;
        add(*hit, to.time_s * i / steps, to.pressure);
    }
}

bool TilesTool::joins_last_stroke() const
{
    const bool one_place = settings_.brush == TileBrush::fill || settings_.brush == TileBrush::grab;
    return last_end_ && !covers_ && !one_place && last_end_->base == under_;
}

double TilesTool::pressure_of(const StrokeSample& move)
{
    // At this speed a stroke is as weak as it gets; smoothed over a few moves.
    constexpr double fast_px = 1600, least = 0.15, newest = 0.35;
    Gesture& g = *gesture_;
    const double since_s = move.time_s - g.last_s;
    if (since_s > 0) {
        const double now = glm::distance(move.p_px, g.last_px) / since_s;
        g.speed_px = glm::mix(g.speed_px, now, newest);
    }
    g.last_px = move.p_px;
    g.last_s = move.time_s;
    return follows_ == Follows::nothing ? move.pressure : std::max(least, 1 - g.speed_px / fast_px);
}

bool TilesTool::picks_point(const ViewportInput& input)
{
    if (!picking_ || !input.pressed) return false;
    picking_ = false;
    if (hit_) point_ = PickedPoint{under_, hit_->at_rest.p, hit_->p_world};
    return true;
}

void TilesTool::extend_stroke(Session& session, const ViewportInput& input)
{
    Gesture& g = *gesture_;
    if (input.wheel != 0) {
        radius_ = rounded(radius(session) * std::pow(1.1, input.wheel), 3);
        if (hit_) g.stroke.radius = radius_ / hit_->scale;
    }
    const bool one_place = g.stroke.brush == TileBrush::fill || g.stroke.brush == TileBrush::grab;
    if (ImGui::GetIO().KeyShift && !one_place) {
        if (!input.moves.empty()) straighten(session, g.begun_px, input.moves.back());
    } else if (g.stroke.brush != TileBrush::fill || takes_several(g.stroke.area))
        for (const StrokeSample& move : input.moves)
            if (const auto hit =
                    surface_.hit(session, g.base, ray_through(session.view.camera, move.p_px))) {
                hit_ = hit;
                add(*hit, move.time_s, pressure_of(move));
            }
    g.joins = g.joins && glm::distance(input.mouse, g.begun_px) < click_slip_px;
}

void TilesTool::go_on(Session& session, const ViewportInput& input)
{
    Gesture& g = *gesture_;
    if (!g.cover) extend_stroke(session, input);
    g.over = g.over || input.released || !input.down;
    // Where reading failed a notice says why.
    if (reading_ && !session.jobs().status()) reading_ = false;
    if (reading_ || !wanted_.empty()) return;
    if (g.layer == 0 && g.files.empty()) return gesture_.reset();
    if (g.over) return finish(session);
    if (g.cover) return; // it is laid when the button is let go
    // One proposal at a time: the next piece waits until the last one can be seen.
    const std::size_t now = g.stroke.samples.size() + g.moves;
    if (g.proposed == now || !session.up_to_date()) return;
    if (session.propose_quietly(painting())) g.proposed = now;
}

Command TilesTool::painting() const
{
    const Gesture& g = *gesture_;
    if (g.cover) return CoverWithTiles{g.layer, g.base, *g.cover, {}, g.files};
    return PaintTiles{g.layer, g.base, g.stroke, {}, g.overlap, g.files};
}

void TilesTool::finish(Session& session)
{
    if (gesture_->joins && last_end_ && last_end_->layer == gesture_->layer) {
        const Camera& camera = session.view.camera;
        gesture_->stroke.samples.front().at = last_end_->at.at_rest;
        straighten(session, project(camera, last_end_->at.p_world).p_px,
                   {gesture_->begun_px, 1, 1});
    }
    const Command command = painting();
    const Gesture g = std::move(*gesture_);
    gesture_.reset();
    if (g.cover && is_tile_layer(session.document(), g.layer)) {
        const Tiling& tiles = *object(session.document(), g.layer).tiles;
        if (tiles.base == g.base && tiles.cover == *g.cover) return; // it is laid already
    }
    const Id fresh = session.committed().next_id;
    if (!session.propose(command)) return session.cancel();
    session.commit();
    if (g.layer == 0) {
        session.selected = fresh;
        begun_ = BegunLayer{fresh, std::exchange(files_, {}), g.overlap};
    }
    if (hit_ && !g.cover) last_end_ = StrokeEnd{session.selected, g.base, *hit_};
}

} // namespace trivar
