// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/between.h"

#include "core/mesh/foot_lock.h"
#include "core/mesh/planting_rates.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>

namespace trivar {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

std::array<glm::dvec3, 8> corners_of(const Box& box)
{
    std::array<glm::dvec3, 8> out;
    for (int c = 0; c < 8; ++c)
        out[static_cast<std::size_t>(c)] = {
            c & 1 ? box.hi.x : box.lo.x, c & 2 ? box.hi.y : box.lo.y, c & 4 ? box.hi.z : box.lo.z};
    return out;
}

// Whether something is where it is at all times, and why not.
std::string why_not_still(const Document& document, Id id, bool itself, std::set<Id>& seen)
{
    if (!seen.insert(id).second) return {};
    const Object& o = object(document, id);
    for (const Track& track : o.tracks)
        if (!track.parameter.starts_with("material.") && track.parameter != "hidden" &&
            !(itself && KeyedVolume::is_of_it(o, track)))
            return itself ? "its " + track.parameter + " has keys" : "what it lies on has keys";
    if (!itself && !o.playing.clip.empty()) return "what it lies on plays a clip";
    if (!itself && o.travel.speed != 0 && o.placement) return "what it lies on travels";
    if (o.parent != 0 && !o.placement)
        if (std::string why = why_not_still(document, o.parent, itself, seen); !why.empty())
            return itself ? "its group has keys" : why;
    if (o.placement)
        for (const Id lower : o.placement->onto)
            if (document.objects.contains(lower))
                if (std::string why = why_not_still(document, lower, false, seen); !why.empty())
                    return why;
    return {};
}

// The time of a clip, as it would go on without an end, and where that is in the clip.
struct ClipClock {
    double begin = 0, length = 0;
    Repeat repeat = Repeat::loop;
    double folded(double t) const
    {
        const double x = t - begin;
        if (!(length > 0)) return begin;
        if (repeat == Repeat::once) return begin + std::clamp(x, 0.0, length);
        if (repeat == Repeat::loop) return begin + x - std::floor(x / length) * length;
        const double y = x - std::floor(x / (2 * length)) * 2 * length;
        return begin + (y > length ? 2 * length - y : y);
    }
    // Whether laps are told apart there; much further on a step of the time is more than one.
    bool counts(double t) const
    {
        constexpr double furthest_lap = 1e9;
        return repeat == Repeat::once || !(length > 0) ||
               std::abs(t - begin) < furthest_lap * length;
    }
    // The moments between two at which the clip goes on otherwise, ascending, with the two; nothing
    // where they are very many.
    std::optional<std::vector<double>> cuts(double from, double to,
                                            const std::vector<double>& breaks) const
    {
        std::vector<double> out{from, to};
        const auto add = [&](double t) {
            if (t > from && t < to) out.push_back(t);
        };
        const double lap = repeat == Repeat::back_and_forth ? 2 * length : length;
        const bool once = repeat == Repeat::once || !(length > 0);
        const double first = once ? 0 : std::floor((from - begin) / lap),
                     last = once ? 0 : std::floor((to - begin) / lap);
        constexpr double most_laps = 64;
        if (!(last - first < most_laps)) return {};
        for (double k = first; k <= last; ++k)
            for (const double b : breaks) {
                add(b + k * lap);
                if (repeat == Repeat::back_and_forth) add(2 * (begin + length) - b + k * lap);
            }
        std::ranges::sort(out);
        return out;
    }
};

} // namespace

std::string why_unproven(const Document& document, Id id)
{
    std::set<Id> seen;
    return why_not_still(document, id, true, seen);
}

Between::Between(const Document& document, Id id, const AssetStore& assets)
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

VolumeBends& Between::bends(const Ref<Lattice>& volume)
{
    std::unique_ptr<VolumeBends>& known = bends_[volume];
    if (!known) known = std::make_unique<VolumeBends>(*volume);
    return *known;
}

// One part on its way from one moment to another.
struct Between::Moving {
    const EvaluatedObject& object;
    const Part &a, &b;
    int node = -1, member = 0;
    double from_s = 0, to_s = 0;                       // of the document's time
    double shift_from = 0, shift_to = 0, uneven_u = 0; // of u, laps counted
    glm::dmat4 e0{1}, e1{1};                           // to_uvw at both, laps counted
};

// How far a matrix moves the points of a box by each axis, at most; or the differences in it.
struct Between::Deviation {
    static glm::dvec3 of_points(const glm::dmat4& off, const Box& box)
    {
        glm::dvec3 out(0);
        for (const glm::dvec3& p : corners_of(box))
            out = glm::max(out, glm::abs(glm::dvec3(off * glm::dvec4(p, 1))));
        return out;
    }
    static glm::dvec3 of_differences(const glm::dmat4& off, const Box& box)
    {
        glm::dvec3 out(0);
        for (const glm::dvec3& d : corners_of(box))
            out = glm::max(out, glm::abs(glm::dmat3(off) * d));
        return out;
    }
};

// How far the points are from going evenly, by u, v and w; nothing: not known.
std::optional<glm::dvec3> Between::deviation(const Moving& m) const
{
    glm::dvec3 out(m.uneven_u, 0, 0);
    const Playing& playing = object_.playing;
    if (playing.clip.empty() || !model_) return out;
    const auto clip = std::ranges::find(model_->clips, playing.clip, &Clip::name);
    if (clip == model_->clips.end()) return out;
    const bool locked = m.object.walk && m.object.walk->trouble.empty();
    const Gait* gait = locked ? m.object.walk->gait.get() : nullptr;
    const Node& node = model_->nodes[static_cast<std::size_t>(m.node)];
    const Mesh& mesh = *model_->meshes[static_cast<std::size_t>(node.mesh)];
    const ImportedFile& file = std::get<ImportedFile>(object_.source);
    std::vector<Box> targets = target_bounds(*m.a.rest);
    const auto weights_of = [&](const Part& part) {
        std::vector<float> weights(targets.size(), 0);
        if (part.posed) std::ranges::copy(part.posed->pose.morph_weights, weights.begin());
        return weights;
    };
    const std::vector<float> weights_from = weights_of(m.a), weights_to = weights_of(m.b);
    const auto any = [](const std::vector<float>& weights) {
        return std::ranges::any_of(weights, [](float weight) { return weight != 0; });
    };
    const bool swells = any(weights_from) || any(weights_to) ||
                        std::ranges::any_of(clip->channels, [&](const Channel& c) {
                            return c.node == m.node && c.of == Channel::Of::morph_weights;
                        });
    if (!swells) targets.clear();
    if (file.subdivisions > 0 && node.skin >= 0) return out; // stands as it came
    const glm::dmat3 turned(object_.transform.matrix());
    const glm::dmat4 base = m.object.placement->embedding.to_uvw * glm::dmat4(turned);
    // What is mirrored is turned inside out before it is laid, at every moment anew.
    if (glm::determinant(turned) *
            glm::determinant(glm::dmat3(
                mesh_to_model(*model_, m.node, stance_at(*model_, &*clip, clip->begin_s)))) <
        0)
        return {};

    ClipClock clock{clip->begin_s, clip->end_s - clip->begin_s, playing.repeat};
    double t0, t1, uneven_t = 0;
    const double offset =
        playing.offset + m.member * object_.travel.phase * (clip->end_s - clip->begin_s);
    if (locked) {
        const Walk& walk = *m.object.walk;
        const double period = gait->period_s;
        clock = {gait->begin_s, period, Repeat::loop};
        const auto time = [&](double s) {
            const double gone = m.object.journey->at(s, m.member).gone_u;
            return gait->begin_s + offset + gone / walk.stride_u * period;
        };
        const double since = object_.travel.start_frame / frames_per_second_;
        t0 = time(m.from_s - since);
        t1 = time(m.to_s - since);
        uneven_t = m.uneven_u / std::abs(walk.stride_u) * period;
    } else {
        const double since = playing.start_frame / frames_per_second_;
        t0 = clip->begin_s + offset + playing.speed * std::max(0.0, m.from_s - since);
        t1 = clip->begin_s + offset + playing.speed * std::max(0.0, m.to_s - since);
    }
    if (!clock.counts(t0) || !clock.counts(t1)) return {};
    if (t0 == t1) return out;

    // What moves the points: one matrix, or one for each joint that has a share in some.
    struct Mover {
        int node;
        glm::dmat4 before{1}; // of the points, first
        Box box;              // of those
        glm::dmat4 at_from{1}, at_to{1};
    };
    std::vector<Mover> movers;
    if (node.skin < 0) {
        movers.push_back({m.node, glm::dmat4(1), bounding_box(*m.a.rest), m.e0, m.e1});
    } else {
        const Skin& skin = model_->skins[static_cast<std::size_t>(node.skin)];
        std::vector<Box> boxes(skin.joints.size());
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            for (int k = 0; k < 4; ++k)
                if (mesh.influences[v].weights[k] > 0)
                    boxes[mesh.influences[v].joints[static_cast<std::size_t>(k)]].add(
                        glm::dvec3(mesh.positions[v]));
        const auto joints_at = [](const Part& part) { return part.posed->pose.joints; };
        const std::vector<glm::mat4> from = joints_at(m.a), to = joints_at(m.b);
        for (std::size_t j = 0; j < boxes.size(); ++j)
            if (!boxes[j].empty())
                movers.push_back({skin.joints[j], skin.mesh_to_joint[j], boxes[j],
                                  m.e0 * glm::dmat4(from[j]), m.e1 * glm::dmat4(to[j])});
    }
    glm::dvec3 rows(0); // how long a step in the model is by u, v and w
    for (int a = 0; a < 3; ++a)
        rows[a] = glm::length(glm::dvec3(base[0][a], base[1][a], base[2][a]));

    const double lo = std::min(t0, t1), hi = std::max(t0, t1);
    const auto known_cuts = clock.cuts(lo, hi, breaks_of(*clip, gait));
    if (!known_cuts) return {};
    const std::vector<double>& cuts = *known_cuts;
    const std::vector<int> legs = gait ? legs_of_nodes(*model_, *gait) : std::vector<int>{};
    glm::dvec3 at_cuts(0);
    double smooth = 0; // in the model's units
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const double h = cuts[c + 1] - cuts[c];
        const double middle = clock.folded((cuts[c] + cuts[c + 1]) / 2);
        const double from = std::max(middle - h / 2, clip->begin_s),
                     to = std::min(middle + h / 2, clip->end_s);
        const bool returns = clock.folded(cuts[c] + 0.75 * h) < middle;
        const double within = 1e-9 * (to - from); // where a channel steps both sides are looked at
        for (const bool end : {false, true}) {
            const double t = end != returns ? to - within : from + within;
            const Stance stance =
                gait ? planted(*model_, *clip, *gait, t) : stance_at(*model_, &*clip, t);
            const double share = ((end ? cuts[c + 1] : cuts[c]) - t0) / (t1 - t0);
            const double shift = glm::mix(m.shift_from, m.shift_to, share);
            const glm::dmat4 there = glm::translate(glm::dmat4(1), {shift, 0, 0}) * base;
            for (const Mover& mover : movers) {
                const glm::dmat4 now =
                    there * stance.to_model[static_cast<std::size_t>(mover.node)] * mover.before;
                const glm::dmat4 a = mover.at_from * (1 - share), b = mover.at_to * share;
                glm::dvec3 off = Deviation::of_points(now - (a + b), mover.box);
                for (std::size_t k = 0; k < targets.size(); ++k) {
                    const double w = stance.morph_weights[static_cast<std::size_t>(m.node)][k];
                    off += Deviation::of_differences(
                        now * w - (a * double{weights_from[k]} + b * double{weights_to[k]}),
                        targets[k]);
                }
                at_cuts = glm::max(at_cuts, off);
            }
        }
        const auto local = local_rates(*model_, *clip, from, to);
        if (!local) return {};
        const std::vector<NodeRates> rates = node_rates(*model_, *local);
        std::map<int, PlantingRates> planting; // by foot
        const std::vector<WeightRates> swelling =
            targets.empty() ? std::vector<WeightRates>{}
                            : weight_rates(*model_, *clip, m.node, from, to);
        for (const Mover& mover : movers) {
            double far = 0;
            for (const glm::dvec3& p : corners_of(mover.box))
                far = std::max(far, glm::length(glm::dvec3(mover.before * glm::dvec4(p, 1))));
            double first = 0, second = 0; // of the point itself, by its targets
            for (std::size_t k = 0; k < targets.size(); ++k) {
                double size = 0;
                for (const glm::dvec3& d : corners_of(targets[k]))
                    size = std::max(size, glm::length(glm::dmat3(mover.before) * d));
                far += swelling[k].most * size;
                first += swelling[k].first * size;
                second += swelling[k].second * size;
            }
            const NodeRates& r = rates[static_cast<std::size_t>(mover.node)];
            double turn = r.turn * far + r.shift + r.size * first,
                   bend = r.bend * far + r.swing + 2 * r.turn * first + r.size * second;
            if (const int leg = gait ? legs[static_cast<std::size_t>(mover.node)] : -1; leg >= 0) {
                if (!planting.contains(leg)) {
                    const auto known = PlantingRates::of(
                        *model_, *clip, *gait, static_cast<std::size_t>(leg), *local, from, to);
                    if (!known) return {};
                    planting.emplace(leg, *known);
                }
                const auto by_leg = planting.at(leg).at(mover.node, {far, first, second});
                turn += by_leg.first;
                bend += by_leg.second;
            }
            smooth = std::max(smooth, bend * h * h / 8 + turn * (uneven_t + within));
        }
    }
    return out + at_cuts + rows * smooth;
}

double Between::operator()(const EvaluatedObject& from, const Part& a, double from_frame,
                           const EvaluatedObject& to, const Part& b, double to_frame)
{
    if (!unknown_.empty() || !a.bent || !b.bent) return no_bound;
    if (from.placement != to.placement && !keyed_) return no_bound;
    Moving m{from, a, b};
    const std::size_t meshes = model_ ? nodes_.size() : 1;
    m.member = a.slot / static_cast<int>(meshes);
    if (model_) m.node = nodes_[static_cast<std::size_t>(a.slot) % meshes];
    m.from_s = from_frame / frames_per_second_;
    m.to_s = to_frame / frames_per_second_;
    double laps = 0; // that the one is ahead of the other, though they are at the same place
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
    const std::optional<glm::dvec3> dev = deviation(m);
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
        for (const glm::dvec3& corner : corners_of(bounding_box(*a.rest))) add(corner, corner);
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
        // The scene's volume ends somewhere behind the model's box, and what is further flat there.
        const PlacementParameters& p = object_.placement->parameters;
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
    // The ends of the chord may be off by the seam, and so may be what is between.
    return bend.off_chord(step) + glm::dot(slopes, *dev) + changed + 2 * off;
}

double Between::stretch(const Part& part)
{
    const Embedding& e = part.bent->embedding;
    const VolumeBends& bend = bends(part.bent->volume);
    double out = 0;
    for (int a = 0; a < 3; ++a)
        out += bend.slopes()[a] *
               glm::length(glm::dvec3(e.to_uvw[0][a], e.to_uvw[1][a], e.to_uvw[2][a]));
    return out;
}

double Between::space(const Part& part, const std::vector<glm::vec3>& before_volume,
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
