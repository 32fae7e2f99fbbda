// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/motion_bound.h"

#include "core/certificate/clip_deviation.h"
#include "core/placement/journey.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>

namespace trivar {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

// Says why something may move; empty if it is still at all times.
std::string why_not_still(const Document& document, Id id, bool itself, std::set<Id>& seen)
{
    if (!seen.insert(id).second) return {};
    const Object& o = object(document, id);
    for (const Track& track : o.tracks)
        if (!track.parameter.starts_with("material.") && track.parameter != "hidden" &&
            !(itself && KeyedVolume::is_of_it(o, track)))
            return itself ? "its " + track.parameter + " has keys" : "what it lies on has keys";
    for (const Id lattice : lattices_round(document, id))
        if (itself || !object(document, lattice).tracks.empty())
            return itself ? "a lattice bends it" : "a lattice round what it lies on has keys";
    if (!itself && !o.playing.clip.empty()) return "what it lies on plays a clip";
    if (!itself && o.travel.speed != 0 && o.stroke) return "what it lies on travels";
    if (o.parent != 0 && !o.stroke)
        if (std::string why = why_not_still(document, o.parent, itself, seen); !why.empty())
            return itself ? "its group has keys" : why;
    if (o.stroke)
        for (const Id lower : o.stroke->onto)
            if (document.objects.contains(lower))
                if (std::string why = why_not_still(document, lower, false, seen); !why.empty())
                    return why;
    return {};
}

} // namespace

std::string why_unproven(const Document& document, Id id)
{
    std::set<Id> seen;
    return why_not_still(document, id, true, seen);
}

MotionBound::MotionBound(const Document& document, Id id, const AssetStore& assets)
    : unknown_(why_unproven(document, id)),
      object_(object(document, id)),
      keyed_(KeyedVolume::of(object_)),
      frames_per_second_(document.time.frames_per_second)
{
    if (const auto* file = std::get_if<ImportedFile>(&object_.source)) {
        model_ = assets.load(*file).model;
        if (!model_) return;
        for (std::size_t n = 0; n < model_->nodes.size(); ++n)
            if (model_->nodes[n].mesh >= 0) nodes_.push_back(static_cast<int>(n));
    }
}

VolumeBends& MotionBound::bends(const Ref<Lattice>& volume)
{
    std::unique_ptr<VolumeBends>& known = bends_[volume];
    if (!known) known = std::make_unique<VolumeBends>(*volume);
    return *known;
}

double MotionBound::operator()(const EvaluatedObject& from, const Part& a, double from_frame,
                               const EvaluatedObject& to, const Part& b, double to_frame)
{
    if (!unknown_.empty() || !a.bent || !b.bent) return no_bound;
    if (from.placement != to.placement && !keyed_) return no_bound;
    PartOnItsWay m{object_, from, a, b, frames_per_second_};
    m.member = a.key.member;
    if (model_) {
        m.model = model_.get();
        m.node = nodes_[static_cast<std::size_t>(a.key.mesh)];
    }
    m.from_s = from_frame / frames_per_second_;
    m.to_s = to_frame / frames_per_second_;
    double laps = 0; // that one is ahead of the other at the same place
    if (from.journey) {
        const Journey& journey = *from.journey;
        const double since = object_.travel.start_frame / frames_per_second_;
        const Journey::Place p = journey.at(m.from_s - since, m.member),
                             q = journey.at(m.to_s - since, m.member);
        const double ahead = (q.gone_u - p.gone_u) - (q.shift_u - p.shift_u);
        laps = std::round(ahead);
        constexpr double rounding = 1e-6;
        if (std::abs(ahead - laps) > rounding) return no_bound; // it jumps
        const double lap = journey.line().rounds_to_start();
        if (laps != 0 && std::remainder(laps, lap) != 0) return no_bound;
        m.shift_from = p.shift_u;
        m.shift_to = q.shift_u + laps;
        m.uneven_u = journey.unevenness_u(m.from_s - since, m.to_s - since, m.member);
    }
    m.e0 = a.bent->embedding.to_uvw;
    m.e1 = glm::translate(glm::dmat4(1), {laps, 0, 0}) * b.bent->embedding.to_uvw;
    const std::optional<glm::dvec3> dev = deviation_of(m);
    if (!dev) return no_bound;

    glm::dvec3 step(0);
    Box swept, along; // and without the travel
    const auto add = [&](const glm::dvec3& p, const glm::dvec3& q) {
        const glm::dvec3 u(m.e0 * glm::dvec4(p, 1)), v(m.e1 * glm::dvec4(q, 1));
        step = glm::max(step, glm::abs(v - u));
        swept.add(u);
        swept.add(v);
        along.add(u - glm::dvec3(m.shift_from, 0, 0));
        along.add(v - glm::dvec3(m.shift_to, 0, 0));
    };
    if (a.posed || b.posed) {
        const Mesh &p = *a.before_volume(), &q = *b.before_volume();
        for (std::size_t v = 0; v < p.vertex_count(); ++v)
            add(glm::dvec3(p.positions[v]), glm::dvec3(q.positions[v]));
    } else {
        if (a.rest != b.rest) return no_bound;
        for (const glm::dvec3& corner : bounding_box(*a.rest).corners()) add(corner, corner);
    }
    swept.lo -= *dev;
    swept.hi += *dev;
    const auto reached =
        volumes_.over(from, swept.lo.x, swept.hi.x, laps, {a.bent->volume, b.bent->volume});
    if (!reached) return no_bound;
    swept.lo.x += reached->shift_u;
    swept.hi.x += reached->shift_u;
    VolumeBends::Bend bend = bends(reached->volume).over(swept);
    glm::dvec3 slopes = bends(reached->volume).slopes();
    double off = reached->seam;
    if (reached->clamped) {
        // The volume ends somewhere behind the box of the model and continues linearly there.
        const PlacementParameters& p = object_.stroke->parameters;
        const double moved = dev->x - m.uneven_u; // by the clip
        off += slopes.x * std::max({0.0, p.start - (along.lo.x - moved),
                                    along.hi.x + moved - (p.start + p.fill)});
    }
    double changed = 0; // by the volume itself
    if (keyed_) {
        bend = greater(bend, bends(b.bent->volume).over(swept));
        slopes = glm::max(slopes, bends(b.bent->volume).slopes());
        const auto change = keyed_->change(from, from_frame, to, to_frame, slopes);
        if (!change) return no_bound;
        changed = change->uneven + glm::dot(change->turn, step) / 4;
    }
    // The ends of the chord, and everything between them, may be off by the seam.
    return bend.off_chord(step) + glm::dot(slopes, *dev) + changed + 2 * off;
}

double MotionBound::stretch(const Part& part)
{
    const Embedding& e = part.bent->embedding;
    const VolumeBends& bend = bends(part.bent->volume);
    double out = 0;
    for (int a = 0; a < 3; ++a)
        out += bend.slopes()[a] *
               glm::length(glm::dvec3(e.to_uvw[0][a], e.to_uvw[1][a], e.to_uvw[2][a]));
    return out;
}

double MotionBound::space(const Part& part, const std::vector<glm::vec3>& before_volume,
                          const std::vector<glm::uvec3>& triangles)
{
    const glm::dmat4& to_uvw = part.bent->embedding.to_uvw;
    std::vector<glm::dvec3> uvw(before_volume.size());
    Box all;
    for (std::size_t v = 0; v < uvw.size(); ++v) {
        uvw[v] = glm::dvec3(to_uvw * glm::dvec4(glm::dvec3(before_volume[v]), 1));
        all.add(uvw[v]);
    }
    if (all.empty()) return 0;
    const VolumeBends::Bend bend = bends(part.bent->volume).over(all);
    const bool kinks = bend.kink != glm::dvec3(0);
    double out = 0;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 p = glm::abs(uvw[t.y] - uvw[t.x]), q = glm::abs(uvw[t.z] - uvw[t.x]);
        if (!kinks) {
            out = std::max(out, bend.off_triangle(p, q));
            continue;
        }
        Box own;
        for (int c = 0; c < 3; ++c) own.add(uvw[t[c]]);
        out = std::max(out, bends(part.bent->volume).over(own).off_triangle(p, q));
    }
    return out;
}

} // namespace trivar
