// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/cut_stroke.h"

#include "editor/tools/tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {
namespace {

constexpr double sample_px = 4;   // between two points, at scale 1
constexpr double straight_px = 6; // of a straight piece, and of one that a fast hand left out
constexpr int smoothing_rounds = 2;

} // namespace

CutStroke::CutStroke(IncisedSkin skin, std::vector<CutEnd> ends, const SurfaceHit& from,
                     glm::dvec2 at_px)
    : skin_(std::move(skin)),
      ends_(std::move(ends)),
      hits_{{from, false}},
      begun_px_(at_px),
      last_px_(at_px)
{
}

void CutStroke::add(const Camera& camera, glm::dvec2 p_px, bool free)
{
    if (const auto hit = skin_.hit(ray_through(camera, p_px))) hits_.push_back({*hit, free});
}

void CutStroke::go_straight(const Camera& camera, glm::dvec2 to_px)
{
    hits_.resize(std::min(corner_ + 1, hits_.size()));
    const glm::dvec2 from = project(camera, hits_.back().hit.p_world).p_px;
    const int steps =
        std::max(1, static_cast<int>(std::ceil(glm::distance(from, to_px) / straight_px)));
    for (int i = 1; i <= steps; ++i)
        add(camera, glm::mix(from, to_px, static_cast<double>(i) / steps), false);
}

void CutStroke::go_freely(const Camera& camera, glm::dvec2 to_px)
{
    const glm::dvec2 from = project(camera, hits_.back().hit.p_world).p_px;
    const int steps = std::max(1, static_cast<int>(glm::distance(from, to_px) / straight_px));
    for (int i = 1; i <= steps; ++i)
        add(camera, glm::mix(from, to_px, static_cast<double>(i) / steps), true);
}

bool CutStroke::take(const Camera& camera, const std::vector<StrokeSample>& moves,
                     const CutKeys& keys)
{
    if (keys.straight && !straight_) {
        at_end_.reset();
        corner_ = hits_.size() - 1;
    }
    straight_ = keys.straight;
    bool changed = false;
    for (const StrokeSample& move : moves) {
        moved_ = moved_ || glm::distance(move.p_px, begun_px_) > click_slip_px;
        if (move.p_px == last_px_ || !moved_) continue;
        const CutEnd* end = end_near(ends_, camera, move.p_px, end_reach_px * keys.scale);
        if (!straight_ && !end &&
            glm::distance(move.p_px, project(camera, hits_.back().hit.p_world).p_px) <
                sample_px * keys.scale)
            continue;
        last_px_ = move.p_px;
        changed = true;
        // What the pull of an end added goes as soon as the hand goes on
        if (std::exchange(at_end_, std::nullopt) && !straight_ && hits_.size() > 1)
            hits_.pop_back();
        const glm::dvec2 to = end ? project(camera, end->p_world).p_px : move.p_px;
        if (straight_)
            go_straight(camera, to);
        else if (!end)
            go_freely(camera, to);
        if (!end) continue;
        at_end_ = *end;
        SurfaceHit there = hits_.back().hit;
        there.p_world = end->p_world;
        there.at_rest = end->at_rest;
        if (straight_ && hits_.size() > corner_ + 1)
            hits_.back() = {there, false};
        else
            hits_.push_back({there, false});
    }
    return changed;
}

std::vector<SurfacePoint> CutStroke::points() const
{
    std::vector<SurfacePoint> out;
    for (const CutSample& each : hits_) out.push_back(each.hit.at_rest);
    if (out.size() < 2) return {};
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

std::vector<glm::dvec3> CutStroke::way_world() const
{
    std::vector<glm::dvec3> out;
    for (const CutSample& each : hits_) out.push_back(each.hit.p_world);
    return out;
}

double CutStroke::length_world() const
{
    double out = 0;
    for (std::size_t i = 1; i < hits_.size(); ++i)
        out += glm::distance(hits_[i - 1].hit.p_world, hits_[i].hit.p_world);
    return out;
}

} // namespace trivar
