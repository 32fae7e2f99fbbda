// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_stroke.h"

#include "editor/hands/tool.h"
#include "editor/hands/viewport_input.h"
#include "editor/tools/incise/incision_handles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {
namespace {

constexpr double sample_px = 4;   // between two points, at scale 1
constexpr double straight_px = 6; // of a straight piece, and of one that a fast hand left out
constexpr int smoothing_rounds = 2;

} // namespace

IncisionStroke::IncisionStroke(IncisedSkin skin, IncisionSnaps snaps, const SurfaceHit& from,
                               glm::dvec2 at_px)
    : skin_(std::move(skin)),
      snaps_(std::move(snaps)),
      hits_{{from, false}},
      begun_px_(at_px),
      last_px_(at_px)
{
}

void IncisionStroke::add(const Camera& camera, glm::dvec2 p_px, bool free)
{
    const Ray ray = ray_through(camera, p_px);
    const auto hit = skin_.hit(ray);
    if (hit) hits_.push_back({*hit, free});
    on_wall_ = hit ? std::nullopt : skin_.wall_hit(ray);
}

void IncisionStroke::go_straight(const Camera& camera, glm::dvec2 to_px)
{
    hits_.resize(std::min(corner_ + 1, hits_.size()));
    const glm::dvec2 from = project(camera, hits_.back().hit.p_world).p_px;
    const int steps =
        std::max(1, static_cast<int>(std::ceil(glm::distance(from, to_px) / straight_px)));
    for (int i = 1; i <= steps; ++i)
        add(camera, glm::mix(from, to_px, static_cast<double>(i) / steps), false);
}

void IncisionStroke::go_freely(const Camera& camera, glm::dvec2 to_px)
{
    const glm::dvec2 from = project(camera, hits_.back().hit.p_world).p_px;
    const int steps = std::max(1, static_cast<int>(glm::distance(from, to_px) / straight_px));
    for (int i = 1; i <= steps; ++i)
        add(camera, glm::mix(from, to_px, static_cast<double>(i) / steps), true);
}

bool IncisionStroke::lacks_uv() const
{
    return uv_lines_ && (*uv_lines_)[0].places.empty() && (*uv_lines_)[1].places.empty();
}

void IncisionStroke::go_along_uv(const Camera& camera, glm::dvec2 to_px)
{
    double nearest = 1e300;
    const IncisedSkin::SeenUvLine* on = nullptr;
    std::size_t at = 0;
    double share = 0;
    for (const IncisedSkin::SeenUvLine& line : *uv_lines_)
        for (std::size_t i = 1; i < line.places.size(); ++i) {
            const SurfaceHit &a = line.places[i - 1], &b = line.places[i];
            const PicturePoint pa = project(camera, a.p_world), pb = project(camera, b.p_world);
            if (!(pa.depth_world > 0) || !(pb.depth_world > 0)) continue;
            const bool behind =
                glm::dot(a.normal_world, ray_through(camera, pa.p_px).direction) > 0;
            if (behind) continue;
            const glm::dvec2 way = pb.p_px - pa.p_px;
            const double far = glm::dot(way, way);
            const double t =
                far > 0 ? std::clamp(glm::dot(to_px - pa.p_px, way) / far, 0.0, 1.0) : 0;
            const double away = glm::distance(pa.p_px + t * way, to_px);
            if (away >= nearest) continue;
            nearest = away;
            on = &line;
            at = i;
            share = t;
        }
    if (!on) return;
    hits_.resize(1);
    const auto take = [&](std::size_t i) { hits_.push_back({on->places[i], false}); };
    if (at > on->start)
        for (std::size_t i = on->start + 1; i < at; ++i) take(i);
    else
        for (std::size_t i = on->start; i-- > at;) take(i);
    const SurfaceHit &a = on->places[at - 1], &b = on->places[at];
    SurfaceHit last = share < 0.5 ? a : b;
    last.p_world = glm::mix(a.p_world, b.p_world, share);
    last.at_rest.p = glm::mix(a.at_rest.p, b.at_rest.p, share);
    const glm::dvec3 n = glm::mix(a.at_rest.normal, b.at_rest.normal, share);
    if (glm::length(n) > 1e-9) last.at_rest.normal = glm::normalize(n);
    hits_.push_back({last, false});
}

bool IncisionStroke::take(const Camera& camera, const std::vector<StrokeSample>& moves,
                          const HeldKeys& keys)
{
    if (keys.straight && !straight_) {
        at_end_.reset();
        corner_ = hits_.size() - 1;
    }
    straight_ = keys.straight;
    if (keys.along_uv && !uv_lines_) uv_lines_ = skin_.uv_lines(hits_.front().hit.at_rest);
    const bool along_uv = keys.along_uv && !straight_ && !lacks_uv();
    bool changed = false;
    for (const StrokeSample& move : moves) {
        moved_ = moved_ || glm::distance(move.p_px, begun_px_) > click_slip_px;
        if (move.p_px == last_px_ || !moved_) continue;
        const auto near =
            along_uv ? std::nullopt : snap_near(snaps_, camera, move.p_px, keys.scale);
        // A place along another incision pulls the end where it is let go, and nothing before
        const bool end = near && !near->along;
        if (!straight_ && !along_uv && !end &&
            glm::distance(move.p_px, project(camera, hits_.back().hit.p_world).p_px) <
                sample_px * keys.scale) {
            changed = changed || near || at_end_;
            at_end_ = near;
            continue;
        }
        last_px_ = move.p_px;
        changed = true;
        // A sample that the pull of an end added goes as soon as the hand goes on; a crossing stays
        if (const auto before = std::exchange(at_end_, near);
            before && !before->along && !straight_ && hits_.size() > 1) {
            if (!before->crossing)
                hits_.pop_back();
            else if (end && near->p_world == before->p_world)
                continue;
        }
        const glm::dvec2 to = near ? project(camera, near->p_world).p_px : move.p_px;
        if (along_uv)
            go_along_uv(camera, to);
        else if (straight_)
            go_straight(camera, to);
        else if (!end || near->crossing)
            go_freely(camera, end ? to : move.p_px);
        if (!end) continue;
        SurfaceHit there = hits_.back().hit;
        there.p_world = near->p_world;
        there.at_rest = near->at_rest;
        if (straight_ && hits_.size() > corner_ + 1)
            hits_.back() = {there, false};
        else
            hits_.push_back({there, false});
    }
    return changed;
}

std::vector<SurfacePoint> IncisionStroke::points() const
{
    std::vector<SurfacePoint> out;
    for (const SkinSample& each : hits_) out.push_back(each.hit.at_rest);
    if (out.size() < 2) return {};
    if (at_end_)
        out.back() = at_end_->at_rest;
    else if (on_wall_)
        out.push_back(on_wall_->at_rest);
    for (int round = 0; round < smoothing_rounds; ++round) {
        SurfacePoint before = out.front();
        for (std::size_t i = 1; i + 1 < out.size(); ++i) {
            const SurfacePoint now = out[i];
            if (hits_[i].free) {
                const glm::dvec3 n = before.normal + 2.0 * now.normal + out[i + 1].normal;
                out[i].p = (before.p + 2.0 * now.p + out[i + 1].p) / 4.0;
                if (glm::length(n) > 1e-6) out[i].normal = glm::normalize(n);
            }
            before = now;
        }
    }
    for (SurfacePoint& each : out) each = handy(each);
    return out;
}

std::vector<glm::dvec3> IncisionStroke::way_world() const
{
    std::vector<glm::dvec3> out;
    for (const SkinSample& each : hits_) out.push_back(each.hit.p_world);
    if (at_end_) out.back() = at_end_->p_world;
    return out;
}

} // namespace trivar
