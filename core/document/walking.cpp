// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/walking.h"

#include "core/placement/embed.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>

namespace trivar {
namespace {

const Clip* clip_named(const Model& model, const std::string& name)
{
    const auto found = std::ranges::find(model.clips, name, &Clip::name);
    return found == model.clips.end() ? nullptr : &*found;
}

// All that the slide of a walk comes from.
struct Tread {
    Ref<Model> model;
    std::string clip;
    Walk walk;
    Playing playing;
    Ref<Laid> laid;
    Ref<Journey> journey;
    PlacementParameters parameters;
    glm::dmat4 to_uvw; // of the model, at rest
};

// What the middles of the soles stand over in the world, some time after the model set out.
std::vector<glm::dvec3> soles_at(const Tread& t, const Journey::Place& place)
{
    const Clip& clip = *clip_named(*t.model, t.clip);
    const Stance stance =
        planted(*t.model, clip, *t.walk.gait, t.walk.clip_time_s(t.playing, place.gone_u));
    const Ref<Lattice> volume =
        reaching(Ref<Lattice>(t.laid->placement, &t.laid->placement->volume), *t.journey,
                 t.parameters, {place});
    const Embedding in_volume{glm::dmat4(1), volume->rest};
    std::vector<glm::dvec3> out;
    for (const Foot& foot : t.walk.gait->feet) {
        glm::dvec3 uvw(t.to_uvw * glm::dvec4(sole_at(*t.model, foot, stance), 1));
        uvw.x += place.shift_u;
        uvw.z = t.laid->placement->ground;
        out.push_back(deform(uvw, in_volume, *volume).position_world);
    }
    return out;
}

double slide_of(const Tread& t)
{
    constexpr double samples_a_period = 48, most_seconds = 10;
    constexpr double most_samples = 2000;
    const Gait& gait = *t.walk.gait;
    const double seconds = std::min(t.journey->seconds(), most_seconds);
    const double stride_world =
        std::abs(t.walk.stride_u) * MiddleLine(t.laid->placement->contact).length();
    const double periods = std::abs(t.journey->travel().speed) * seconds / stride_world;
    const int samples = static_cast<int>(std::clamp(periods * samples_a_period, 2.0, most_samples));
    struct Planted {
        double step = -1, lap = 0; // which of its stances, and time through the stroke
        glm::dvec3 at{0};          // where it came down
    };
    std::vector<Planted> feet(gait.feet.size());
    double most = 0;
    for (int i = 0; i <= samples; ++i) {
        const Journey::Place place = t.journey->at(seconds * i / samples);
        if (place.hidden) break;
        const std::vector<glm::dvec3> soles = soles_at(t, place);
        const double time = t.walk.clip_time_s(t.playing, place.gone_u);
        // From the end of an open stroke to its start no foot goes over the ground.
        const double lap =
            t.journey->rounds() ? 0 : std::round(1e3 * (place.gone_u - place.shift_u));
        for (std::size_t f = 0; f < feet.size(); ++f) {
            const Foot& foot = gait.feet[f];
            const double phase = (time - gait.begin_s) / gait.period_s - foot.begin;
            const bool stands = phase - std::floor(phase) <= foot.end - foot.begin;
            Planted& before = feet[f];
            if (!stands)
                before.step = -1;
            else if (before.step < 0 || before.step != std::floor(phase) + 1e6 || before.lap != lap)
                before = {std::floor(phase) + 1e6, lap, soles[f]};
            else
                most = std::max(most, glm::distance(before.at, soles[f]));
        }
    }
    return most / stride_world;
}

Walk walk_of(Tread tread)
{
    Walk walk = tread.walk;
    const Gait& gait = *walk.gait;
    const glm::dvec3 stride = glm::dmat3(tread.to_uvw) * (gait.forward * gait.stride);
    if (!gait.trouble.empty()) {
        walk.trouble =
            fmt::format("its feet are not locked: in \"{}\" {}", tread.clip, gait.trouble);
        return walk;
    }
    walk.stride_u = stride.x;
    const double length = tread.laid->placement->report.length_world;
    const double width = tread.laid->placement->report.width_world;
    if (std::abs(stride.x) * length < std::abs(stride.y) * width) {
        walk.trouble = fmt::format(
            "its feet are not locked: in \"{}\" it walks across its stroke; turn it", tread.clip);
        return walk;
    }
    walk.natural_speed =
        std::abs(stride.x) * MiddleLine(tread.laid->placement->contact).length() / gait.period_s;
    // Its front is where its feet take it, which is not always where its file's format has fronts.
    if (tread.journey->travel().speed > 0 && (stride.x < 0) != looks_back(tread.parameters))
        walk.remark = fmt::format(
            "in \"{}\" it walks backwards; a negative speed lets it walk the way it looks",
            tread.clip);
    walk.correction = largest_correction(*tread.model, *clip_named(*tread.model, tread.clip), gait);
    tread.walk = walk;
    walk.slide = Lazy<double>([tread = std::move(tread)] { return slide_of(tread); });
    return walk;
}

} // namespace

double Walk::clip_time_s(const Playing& playing, double gone_u) const
{
    const double t = playing.offset / gait->period_s + gone_u / stride_u;
    return gait->begin_s + (t - std::floor(t)) * gait->period_s;
}

Ref<Gait> Walking::gait_of(const Ref<Model>& model, const std::string& clip, const glm::dvec3& up)
{
    if (!measured_ || measured_->model != model || measured_->clip != clip ||
        measured_->gait->up != up)
        measured_ = {model, clip, make_ref(trivar::gait_of(*model, *clip_named(*model, clip), up))};
    return measured_->gait;
}

Ref<Walk> Walking::operator()(const Ref<Shape>& shape, const Playing& playing,
                              const Ref<Laid>& laid, const Ref<Journey>& journey,
                              const PlacementParameters& parameters, const glm::dmat3& turned)
{
    if (!playing.foot_lock || !laid->placement || !clip_named(*shape->model, playing.clip))
        return nullptr;
    if (known_ && known_->shape == shape && known_->laid == laid && known_->journey == journey &&
        known_->playing == playing)
        return known_->walk;
    Walk walk;
    if (!journey || journey->travel().speed == 0)
        walk.trouble = "its feet are locked to its travel, and it does not travel";
    else {
        const glm::dmat4 to_uvw = laid->placement->embedding.to_uvw * glm::dmat4(turned);
        const glm::dvec3 up = glm::normalize(glm::row(glm::dmat3(to_uvw), 2));
        walk.gait = gait_of(shape->model, playing.clip, up);
        walk =
            walk_of({shape->model, playing.clip, walk, playing, laid, journey, parameters, to_uvw});
    }
    known_ = {shape, laid, journey, playing, make_ref(std::move(walk))};
    return known_->walk;
}

} // namespace trivar
