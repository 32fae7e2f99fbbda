// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/moving/walks.h"

#include "core/base/text.h"
#include "core/placement/embed.h"
#include "core/stages/reaching.h"
#include "core/walking/pose_rates.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace trivar {
namespace {

const Clip* clip_named(const Model& model, const std::string& name)
{
    const auto found = std::ranges::find(model.clips, name, &Clip::name);
    return found == model.clips.end() ? nullptr : &*found;
}

// A Tread holds everything that the sliding of planted feet depends on.
struct Tread {
    Ref<Model> model;
    std::string clip;
    Walk walk;
    Playing playing;
    Ref<Stage> laid;
    Ref<Journey> journey;
    PlacementParameters parameters;
    glm::dmat4 to_uvw; // of the model, at rest
    double floor;      // height of the contact surface in the model

    Stance stance_at(double clip_time_s) const
    {
        return planted(*model, *clip_named(*model, clip), *walk.gait, clip_time_s);
    }
};

// Soles are the vertices of legs that touch the ground at some time.
struct Soles {
    std::vector<ModelVertex> vertices;
    double within; // height in the model up to which they touch
};

Soles soles_of(const Tread& t)
{
    constexpr double touching = 2e-3; // of the height
    constexpr double hanging = 25;    // times that, as gait_of looks for feet
    constexpr std::size_t most = 256, all = std::numeric_limits<std::size_t>::max();
    std::vector<Stance> stances;
    for (const double moment : moments_of(*clip_named(*t.model, t.clip)))
        stances.push_back(t.stance_at(moment));
    const glm::dvec3& up = t.walk.gait->up;
    const double near = touching * glm::dot(glm::abs(up), bounding_box(*t.model).size());
    // Other parts, such as a blade or a tail, may hang lower than the feet.
    const LowVertices low = low_vertices(*t.model, stances, up, hanging * near, t.floor, all);
    const std::vector<int> legs = legs_of_nodes(*t.model, *t.walk.gait);
    std::vector<ModelVertex> of_legs, touching_ones, some;
    for (const ModelVertex& each : low.vertices)
        if (legs[static_cast<std::size_t>(mover_of(*t.model, each))] >= 0) of_legs.push_back(each);
    std::vector<double> lowest(of_legs.size(), std::numeric_limits<double>::infinity());
    for (const Stance& stance : stances) {
        const std::vector<glm::dvec3> at = positions_of(*t.model, of_legs, stance);
        for (std::size_t v = 0; v < at.size(); ++v)
            lowest[v] = std::min(lowest[v], std::max(t.floor, glm::dot(at[v], up)));
    }
    const double ground = of_legs.empty() ? low.ground : *std::ranges::min_element(lowest);
    for (std::size_t v = 0; v < of_legs.size(); ++v)
        if (lowest[v] <= ground + near) touching_ones.push_back(of_legs[v]);
    for (std::size_t i = 0; i < touching_ones.size(); i += touching_ones.size() / most + 1)
        some.push_back(touching_ones[i]);
    return {std::move(some), ground + near};
}

// Finds the world positions of the soles on the ground at a time after the model set out; a sole in
// the air has none.
std::vector<std::optional<glm::dvec3>> touched(const Tread& t, const Soles& soles,
                                               const Journey::Place& place)
{
    const Stance stance = t.stance_at(t.walk.clip_time_s(t.playing, place.gone_u));
    const Ref<Lattice> volume =
        reaching(Ref<Lattice>(t.laid->placement, &t.laid->placement->volume), *t.journey,
                 t.parameters, {place});
    const Embedding in_volume{glm::dmat4(1), volume->rest};
    std::vector<std::optional<glm::dvec3>> out;
    for (const glm::dvec3& p : positions_of(*t.model, soles.vertices, stance)) {
        out.emplace_back();
        if (glm::dot(p, t.walk.gait->up) > soles.within) continue;
        glm::dvec3 uvw(t.to_uvw * glm::dvec4(p, 1));
        uvw.x += place.shift_u;
        uvw.z = t.laid->placement->ground;
        out.back() = deform(uvw, in_volume, *volume).position_world;
    }
    return out;
}

double slide_of(const Tread& t)
{
    constexpr double samples_a_period = 150; // some of them between the poses of the gait
    constexpr double most_seconds = 10;
    constexpr double most_samples = 2000;
    const double seconds = std::min(t.journey->seconds(), most_seconds);
    const double stride_world =
        std::abs(t.walk.stride_u) * MiddleLine(t.laid->placement->contact).length();
    const double periods = std::abs(t.journey->travel().speed) * seconds / stride_world;
    const int samples = static_cast<int>(std::clamp(periods * samples_a_period, 2.0, most_samples));
    const Soles soles = soles_of(t);
    std::vector<std::vector<glm::dvec3>> contacts(soles.vertices.size()); // each since it began
    double most = 0, lap = 0;
    for (int i = 0; i <= samples; ++i) {
        const Journey::Place place = t.journey->at(seconds * i / samples);
        if (place.hidden) break;
        // No foot is on the ground while the model jumps from the end of an open stroke to its
        // start.
        const double now =
            t.journey->rounds() ? 0 : std::round(1e3 * (place.gone_u - place.shift_u));
        if (now != std::exchange(lap, now)) contacts.assign(contacts.size(), {});
        const std::vector<std::optional<glm::dvec3>> at = touched(t, soles, place);
        for (std::size_t v = 0; v < at.size(); ++v) {
            if (!at[v]) contacts[v].clear();
            if (!at[v]) continue;
            for (const glm::dvec3& before : contacts[v])
                most = std::max(most, glm::distance(before, *at[v]));
            contacts[v].push_back(*at[v]);
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
            fmt::format("its feet are not locked: \"{}\" {}", excerpt(tread.clip), gait.trouble);
        return walk;
    }
    walk.stride_u = stride.x;
    const double length = tread.laid->placement->report.length_world;
    const double width = tread.laid->placement->report.width_world;
    if (std::abs(stride.x) * length < std::abs(stride.y) * width) {
        walk.trouble =
            fmt::format("its feet are not locked: in \"{}\" it walks across its stroke; turn it",
                        excerpt(tread.clip));
        return walk;
    }
    walk.natural_speed =
        std::abs(stride.x) * MiddleLine(tread.laid->placement->contact).length() / gait.period_s;
    // The front of a model is where its feet take it, which may differ from the convention of its
    // format.
    if (tread.journey->travel().speed > 0 && (stride.x < 0) != looks_back(tread.parameters))
        walk.remark = fmt::format(
            "in \"{}\" it walks backwards; use a negative speed to let it walk forwards",
            excerpt(tread.clip));
    walk.correction = largest_correction(gait);
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

Ref<Walk> Walks::operator()(const Ref<Shape>& shape, const Playing& playing, const Ref<Stage>& laid,
                            const Ref<Journey>& journey, const PlacementParameters& parameters,
                            const glm::dmat3& turned)
{
    if (!playing.foot_lock || !laid->placement || !clip_named(*shape->model, playing.clip))
        return nullptr;
    return walks_({shape, laid, journey, playing}, [&] {
        Walk walk;
        if (!journey || journey->travel().speed == 0) {
            walk.trouble = "foot lock has no effect, because the object does not travel";
            return make_ref(std::move(walk));
        }
        const glm::dmat4 to_uvw = laid->placement->embedding.to_uvw * glm::dmat4(turned);
        const glm::dvec3 w = glm::row(glm::dmat3(to_uvw), 2), up = glm::normalize(w);
        const double floor = (laid->placement->ground - to_uvw[3].z) / glm::length(w);
        const Model& model = *shape->model;
        walk.gait = gaits_({shape->model, playing.clip, up, floor}, [&] {
            return make_ref(gait_of(model, *clip_named(model, playing.clip), up, floor));
        });
        return make_ref(walk_of(
            {shape->model, playing.clip, walk, playing, laid, journey, parameters, to_uvw, floor}));
    });
}

} // namespace trivar
