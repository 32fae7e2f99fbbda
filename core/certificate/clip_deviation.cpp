// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/clip_deviation.h"

#include "core/base/finite.h"
#include "core/placement/journey.h"
#include "core/placement/placement.h"
#include "core/stages/walk.h"
#include "core/walking/foot_lock.h"
#include "core/walking/planting_rates.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>

namespace trivar {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::size_t index_of(int n)
{
    return static_cast<std::size_t>(n);
}

// A ClipClock maps the time of a clip, which continues past its end, to a time within the clip.
struct ClipClock {
    double begin = 0, length = 0;
    Repeat repeat = Repeat::loop;
    double in_clip(double t) const
    {
        return length > 0 ? begin + folded(repeat, t - begin, length) : begin;
    }
    // Says whether laps can be told apart at t; at very large times one rounding step is more than
    // a lap.
    bool counts(double t) const
    {
        constexpr double furthest_lap = 1e9;
        return repeat == Repeat::once || !(length > 0) ||
               std::abs(t - begin) < furthest_lap * length;
    }
    // Lists the moments from `from` to `to`, both included, at which the motion of the clip
    // changes, ascending; empty if there are too many.
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

// A ClipTime says when in the clip a way begins and ends.
struct ClipTime {
    ClipClock clock;
    double from = 0, to = 0;
    double uneven = 0; // largest difference from an even motion
};

ClipTime time_of(const PartOnItsWay& way, const Clip& clip, const Gait* gait)
{
    const Playing& playing = way.object.playing;
    const double length = clip.end_s - clip.begin_s;
    const double offset = playing.offset + way.member * way.object.travel.phase * length;
    if (gait) {
        const double per_u = gait->period_s / way.evaluated.walk->stride_u;
        const double since = way.object.travel.start_frame / way.frames_per_second;
        const auto time = [&](double s) {
            return gait->begin_s + offset +
                   way.evaluated.journey->at(s - since, way.member).gone_u * per_u;
        };
        return {{gait->begin_s, gait->period_s, Repeat::loop},
                time(way.from_s),
                time(way.to_s),
                way.uneven_u * std::abs(per_u)};
    }
    const double since = playing.start_frame / way.frames_per_second;
    const auto time = [&](double s) {
        return clip.begin_s + offset + playing.speed * std::max(0.0, s - since);
    };
    return {{clip.begin_s, length, playing.repeat}, time(way.from_s), time(way.to_s)};
}

// A Mover moves some of the points: the node of the part, or a joint.
struct Mover {
    int node;
    glm::dmat4 before{1}; // of the points, first
    Box box;              // of those
    glm::dmat4 at_from{1}, at_to{1};
};

std::vector<Mover> movers_of(const PartOnItsWay& way)
{
    const Node& node = way.model->nodes[index_of(way.node)];
    if (node.skin < 0)
        return {{way.node, glm::dmat4(1), bounding_box(*way.a.rest), way.e0, way.e1}};
    const Mesh& mesh = *way.model->meshes[index_of(node.mesh)];
    const Skin& skin = way.model->skins[index_of(node.skin)];
    std::vector<Box> boxes(skin.joints.size());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        for (int k = 0; k < 4; ++k)
            if (mesh.influences[v].weights[k] > 0)
                boxes[mesh.influences[v].joints[index_of(k)]].add(glm::dvec3(mesh.positions[v]));
    const std::vector<glm::mat4>&from = way.a.posed->pose.joints, &to = way.b.posed->pose.joints;
    std::vector<Mover> out;
    for (std::size_t j = 0; j < boxes.size(); ++j)
        if (!boxes[j].empty())
            out.push_back({skin.joints[j], skin.mesh_to_joint[j], boxes[j],
                           way.e0 * glm::dmat4(from[j]), way.e1 * glm::dmat4(to[j])});
    return out;
}

// Targets are the morph targets that have weights on the way, with the boxes of their differences.
struct Targets {
    std::vector<Box> boxes;
    std::vector<float> from, to; // weights
};

Targets targets_of(const PartOnItsWay& way, const Clip& clip)
{
    Targets out{target_bounds(*way.a.rest), {}, {}};
    const auto weights_of = [&](const Part& part) {
        std::vector<float> weights(out.boxes.size(), 0);
        if (part.posed) std::ranges::copy(part.posed->pose.morph_weights, weights.begin());
        return weights;
    };
    out.from = weights_of(way.a);
    out.to = weights_of(way.b);
    const auto any = [](const std::vector<float>& weights) {
        return std::ranges::any_of(weights, [](float weight) { return weight != 0; });
    };
    const bool swells =
        any(out.from) || any(out.to) || std::ranges::any_of(clip.channels, [&](const Channel& c) {
            return c.node == way.node && c.of == Channel::Of::morph_weights;
        });
    return swells ? out : Targets{};
}

class ClipDeviation {
public:
    ClipDeviation(const PartOnItsWay& way, const Clip& clip, const Gait* gait)
        : way_(way),
          clip_(clip),
          gait_(gait),
          targets_(targets_of(way, clip)),
          movers_(movers_of(way)),
          to_uvw_(way.evaluated.placement->embedding.to_uvw *
                  glm::dmat4(glm::dmat3(way.object.transform.matrix())))
    {
        if (gait) legs_ = legs_of_nodes(*way.model, *gait);
    }

    // Bounds the deviation of the clip beyond that of the travel. At time t of the film the clip is
    // at most `uneven` from the even time s: the pose is off the chord at its own time by what the
    // loop below finds, and the chord itself advances by `uneven` times its slope between that time
    // and s.
    std::optional<glm::dvec3> over(const ClipTime& time) const
    {
        const double whole = time.to - time.from;
        // If the clip hardly advances, as at a turn, the chord counts as a point.
        constexpr double hardly = 1e-3;
        const bool stays = whole == 0 || std::abs(whole) < hardly * time.uneven;
        const auto cuts =
            time.clock.cuts(std::min(time.from, time.to) - time.uneven,
                            std::max(time.from, time.to) + time.uneven, breaks_of(clip_, gait_));
        if (!cuts) return {};
        glm::dvec3 at_cuts(0);
        double smooth = 0; // in the model's units
        const auto look = [&](double clip_s, double cut) {
            const double share = stays ? 0 : (cut - time.from) / whole;
            at_cuts = glm::max(at_cuts, off_even(clip_s, share));
        };
        for (std::size_t c = 0; c + 1 < cuts->size(); ++c) {
            const double begin = (*cuts)[c], end = (*cuts)[c + 1], h = end - begin;
            const double middle = time.clock.in_clip((begin + end) / 2),
                         later = time.clock.in_clip(begin + 0.75 * h);
            if (later == middle) { // before its begin, or after its end
                look(middle, begin);
                look(middle, end);
                continue;
            }
            const double from = std::max(middle - h / 2, clip_.begin_s),
                         to = std::min(middle + h / 2, clip_.end_s);
            const bool returns = later < middle;
            // If a channel jumps, both sides of the jump are examined, apart by more than rounding.
            const double largest = std::max({std::abs(begin), std::abs(end), std::abs(to)}),
                         beside = std::min((to - from) / 4,
                                           std::max(1e-9 * (to - from), 8 * epsilon * largest));
            look(returns ? to - beside : from + beside, begin);
            look(returns ? from + beside : to - beside, end);
            const auto change = off_smooth(from, to, h, beside);
            if (!change) return {};
            smooth = std::max(smooth, *change);
        }
        glm::dvec3 out = at_cuts;
        out += stays ? chord() : time.uneven / std::abs(whole) * chord();
        for (int a = 0; a < 3; ++a)
            out[a] += smooth * glm::length(glm::dvec3(to_uvw_[0][a], to_uvw_[1][a], to_uvw_[2][a]));
        return out;
    }

private:
    // Bounds how far a matrix moves the points of a box along each axis; also for boxes of
    // differences.
    static glm::dvec3 of_points(const glm::dmat4& off, const Box& box)
    {
        glm::dvec3 out(0);
        for (const glm::dvec3& p : box.corners())
            out = larger(out, glm::dvec3(off * glm::dvec4(p, 1)));
        return out;
    }
    static glm::dvec3 of_differences(const glm::dmat4& off, const Box& box)
    {
        glm::dvec3 out(0);
        for (const glm::dvec3& d : box.corners()) out = larger(out, glm::dmat3(off) * d);
        return out;
    }
    static glm::dvec3 larger(const glm::dvec3& a, const glm::dvec3& b)
    {
        if (!std::isfinite(b.x + b.y + b.z)) return glm::dvec3(infinite);
        return glm::max(a, glm::abs(b));
    }

    // Bounds how far the points are from the even way at a time of the clip, when `share` of the
    // way is covered.
    glm::dvec3 off_even(double clip_s, double share) const
    {
        const Stance stance = gait_ ? planted(*way_.model, clip_, *gait_, clip_s)
                                    : stance_at(*way_.model, &clip_, clip_s);
        // A mirrored model is turned inside out before it is laid, at every moment.
        if (glm::determinant(glm::dmat3(way_.object.transform.matrix())) *
                glm::determinant(glm::dmat3(mesh_to_model(*way_.model, way_.node, stance))) <
            0)
            return glm::dvec3(infinite);
        const double shift = glm::mix(way_.shift_from, way_.shift_to, share);
        const glm::dmat4 there = glm::translate(glm::dmat4(1), {shift, 0, 0}) * to_uvw_;
        glm::dvec3 out(0);
        for (const Mover& mover : movers_) {
            const glm::dmat4 now = there * stance.to_model[index_of(mover.node)] * mover.before;
            const glm::dmat4 a = mover.at_from * (1 - share), b = mover.at_to * share;
            glm::dvec3 off = of_points(now - (a + b), mover.box);
            for (std::size_t k = 0; k < targets_.boxes.size(); ++k) {
                const double w = stance.morph_weights[index_of(way_.node)][k];
                off += of_differences(
                    now * w - (a * double{targets_.from[k]} + b * double{targets_.to[k]}),
                    targets_.boxes[k]);
            }
            out = glm::max(out, off);
        }
        return out;
    }

    // Bounds how far the points move by the clip alone.
    glm::dvec3 chord() const
    {
        const glm::dmat4 travel =
            glm::translate(glm::dmat4(1), {way_.shift_to - way_.shift_from, 0, 0});
        glm::dvec3 out(0);
        for (const Mover& mover : movers_) {
            const glm::dmat4 from = travel * mover.at_from;
            glm::dvec3 way = of_points(mover.at_to - from, mover.box);
            for (std::size_t k = 0; k < targets_.boxes.size(); ++k)
                way += of_differences(mover.at_to * double{targets_.to[k]} -
                                          from * double{targets_.from[k]},
                                      targets_.boxes[k]);
            out = glm::max(out, way);
        }
        return out;
    }

    // Bounds how far the points are from an even way of duration h between two times of the clip,
    // if its ends may be off by `beside`. In units of the model.
    std::optional<double> off_smooth(double from_s, double to_s, double h, double beside) const
    {
        const Model& model = *way_.model;
        const auto local = local_rates(model, clip_, from_s, to_s);
        if (!local) return {};
        const std::vector<NodeRates> rates = node_rates(model, *local);
        const std::vector<Rates> weights =
            targets_.boxes.empty() ? std::vector<Rates>{}
                                   : weight_rates(model, clip_, way_.node, from_s, to_s);
        std::map<int, PlantingRates> planting; // by foot
        double out = 0;
        for (const Mover& mover : movers_) {
            Rates point; // before the mover's matrix
            for (const glm::dvec3& p : mover.box.corners())
                point.most =
                    std::max(point.most, glm::length(glm::dvec3(mover.before * glm::dvec4(p, 1))));
            for (std::size_t k = 0; k < weights.size(); ++k) {
                double size = 0;
                for (const glm::dvec3& d : targets_.boxes[k].corners())
                    size = std::max(size, glm::length(glm::dmat3(mover.before) * d));
                point.add(weights[k], size);
            }
            Rates moved = rates[index_of(mover.node)].of(point);
            if (const int leg = gait_ ? legs_[index_of(mover.node)] : -1; leg >= 0) {
                if (!planting.contains(leg)) {
                    auto known = PlantingRates::of(model, clip_, *gait_, index_of(leg), *local,
                                                   from_s, to_s);
                    if (!known) return {};
                    planting.emplace(leg, *std::move(known));
                }
                moved.add(planting.at(leg).at(mover.node, point), 1);
            }
            const double off = moved.second * h * h / 8 + moved.first * beside;
            if (!std::isfinite(off)) return {};
            out = std::max(out, off);
        }
        return out;
    }

    const PartOnItsWay& way_;
    const Clip& clip_;
    const Gait* gait_;
    Targets targets_;
    std::vector<Mover> movers_;
    glm::dmat4 to_uvw_; // of the model
    std::vector<int> legs_;
};

} // namespace

std::optional<glm::dvec3> deviation_of(const PartOnItsWay& way)
{
    if (!std::isfinite(way.uneven_u)) return {};
    const glm::dvec3 by_travel(way.uneven_u, 0, 0);
    const Playing& playing = way.object.playing;
    if (playing.clip.empty() || !way.model) return by_travel;
    const auto clip = std::ranges::find(way.model->clips, playing.clip, &Clip::name);
    if (clip == way.model->clips.end()) return by_travel;
    const bool skin = way.model->nodes[index_of(way.node)].skin >= 0;
    if (skin && std::get<ImportedFile>(way.object.source).subdivisions > 0)
        return by_travel; // it stands as it came
    const auto& walk = way.evaluated.walk;
    const Gait* gait = walk && walk->trouble.empty() ? walk->gait.get() : nullptr;
    const ClipTime time = time_of(way, *clip, gait);
    if (!time.clock.counts(time.from) || !time.clock.counts(time.to)) return {};
    if (time.from == time.to && time.uneven == 0) return by_travel;
    const auto by_clip = ClipDeviation(way, *clip, gait).over(time);
    if (!by_clip || !(glm::length(*by_clip) < infinite)) return {};
    return by_travel + *by_clip;
}

} // namespace trivar
