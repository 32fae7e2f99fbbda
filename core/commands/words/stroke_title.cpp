// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/stroke_title.h"

#include "core/commands/words/field_words.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>

namespace trivar {
namespace {

// Says whether a stroke was moved as a whole: its camera moved with it, or was replaced by another
// one because the stroke would be hidden from it.
bool carried_whole(const Sketch& then, const Sketch& now)
{
    const auto same = [](const StrokeSample& a, const StrokeSample& b) {
        return a.time_s == b.time_s && a.pressure == b.pressure;
    };
    return then.camera != now.camera && std::ranges::equal(then.samples, now.samples, same);
}

// SamplePlaces are the places where samples met the scene, then and now, in the space of the
// stroke.
struct SamplePlaces {
    std::vector<glm::dvec3> then, now;
    glm::dvec3 normal{0, 0, 1}; // mean of the faces there
};

glm::dvec3 middle_of(const std::vector<glm::dvec3>& places)
{
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : places) sum += p;
    return sum / static_cast<double>(places.size());
}

// Returns the root mean square of the distances from the middle.
double reach_of(const std::vector<glm::dvec3>& places)
{
    const glm::dvec3 middle = middle_of(places);
    double squares = 0;
    for (const glm::dvec3& p : places) squares += glm::dot(p - middle, p - middle);
    return std::sqrt(squares / static_cast<double>(places.size()));
}

glm::dvec3 place_of(const Attachment& attach, const AttachedSample& sample)
{
    const AttachedHost& host = attach.hosts.at(static_cast<std::size_t>(sample.host));
    return glm::dvec3(host.stood() * glm::dvec4(sample.drawn, 1));
}

glm::dvec3 normal_of(const Attachment& attach, const AttachedSample& sample)
{
    const AttachedHost& host = attach.hosts.at(static_cast<std::size_t>(sample.host));
    return glm::normalize(glm::transpose(glm::inverse(glm::dmat3(host.stood()))) * sample.normal);
}

const std::vector<AttachedSample>* samples_of(const PlacementStep& step)
{
    const bool all = step.attach && step.attach->samples.size() == step.sketch.samples.size();
    return all ? &step.attach->samples : nullptr;
}

// Returns the motion from one camera to the other, each a rigid frame with a size.
glm::dmat4 between(const Camera& then, const Camera& now)
{
    const double factor = glm::distance(now.eye, now.target) / glm::distance(then.eye, then.target);
    const glm::dmat4 grown = glm::scale(glm::dmat4(1), glm::dvec3(factor));
    return glm::inverse(view_matrix(now)) * grown * view_matrix(then);
}

SamplePlaces met_by_camera(const PlacementStep& before, const glm::dmat4& by)
{
    SamplePlaces met;
    if (const auto* samples = samples_of(before)) {
        glm::dvec3 sum(0);
        for (const AttachedSample& each : *samples) {
            if (each.host < 0) continue;
            met.then.push_back(place_of(*before.attach, each));
            sum += normal_of(*before.attach, each);
        }
        if (glm::length(sum) > 0) met.normal = glm::normalize(sum);
    } else if (before.parameters.on_ground) {
        const View view(before.sketch.camera);
        for (const StrokeSample& sample : before.sketch.samples) {
            const Ray ray = view.ray(sample.p_px);
            const double distance = -ray.origin.z / ray.direction.z;
            if (distance > 0 && std::isfinite(distance))
                met.then.push_back(ray.origin + distance * ray.direction);
        }
    }
    for (const glm::dvec3& p : met.then) met.now.emplace_back(by * glm::dvec4(p, 1));
    return met;
}

// Returns the places where both strokes met the scene, and the motion between them. A straight
// stroke does not determine the rotation about itself, so the faces there are used, too.
std::pair<SamplePlaces, glm::dmat4> met_by_samples(const PlacementStep& before,
                                                   const PlacementStep& after)
{
    SamplePlaces met;
    const auto *then = samples_of(before), *now = samples_of(after);
    std::vector<glm::dvec3> normals_then, normals_now;
    for (std::size_t i = 0; then && now && i < then->size(); ++i) {
        if ((*then)[i].host < 0 || (*now)[i].host < 0) continue;
        met.then.push_back(place_of(*before.attach, (*then)[i]));
        met.now.push_back(place_of(*after.attach, (*now)[i]));
        normals_then.push_back(normal_of(*before.attach, (*then)[i]));
        normals_now.push_back(normal_of(*after.attach, (*now)[i]));
    }
    if (met.then.empty()) return {met, glm::dmat4(1)};
    if (const glm::dvec3 mean = middle_of(normals_then); glm::length(mean) > 0)
        met.normal = glm::normalize(mean);
    std::vector<glm::dvec3> from = met.then, to = met.now;
    const double reach = reach_of(met.then);
    for (std::size_t i = 0; i < normals_then.size(); ++i) {
        from.push_back(met.then[i] + reach * normals_then[i]);
        to.push_back(met.now[i] + reach * normals_now[i]);
    }
    return {met, best_motion(from, to)};
}

// Returns the length of the way of the middle sample, which bends as much as the motion turns.
double way_of(const SamplePlaces& met, const glm::dmat4& by)
{
    const std::size_t middle = met.now.size() / 2;
    const double gone = glm::distance(met.now[middle], met.then[middle]);
    const double half =
        std::acos(std::clamp((by[0][0] + by[1][1] + by[2][2] - 1) / 2, -1.0, 1.0)) / 2;
    return half > 1e-6 ? gone * half / std::sin(half) : gone;
}

// Returns the degrees about the normal, right-handed; 0 if the middle moves further than the ends
// turn about it.
double turn_deg(const SamplePlaces& met, const glm::dmat4& by)
{
    if (met.then.empty()) return 0;
    const glm::dmat3 turn(by);
    const glm::dvec3 twice_sine(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2],
                                turn[0][1] - turn[1][0]);
    const double cosine = (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double gone = glm::distance(middle_of(met.now), middle_of(met.then));
    if (gone >= 2 * std::sin(angle / 2) * reach_of(met.then)) return 0;
    return glm::degrees(std::copysign(angle, glm::dot(twice_sine, met.normal)));
}

} // namespace

std::optional<StepTitle> stroke_title(const PlacementStep& before, const PlacementStep& after,
                                      const std::string& name)
{
    if (!carried_whole(before.sketch, after.sketch)) return {};
    SamplePlaces met;
    glm::dmat4 by(1);
    if (before.sketch.samples == after.sketch.samples) {
        by = between(before.sketch.camera, after.sketch.camera);
        met = met_by_camera(before, by);
        if (met.then.empty()) { // of older strokes it is not known what their samples met
            met = met_by_camera(after, glm::inverse(by));
            std::swap(met.then, met.now);
        }
    } else
        std::tie(met, by) = met_by_samples(before, after);
    const double factor = glm::length(glm::dvec3(by[0]));
    if (std::abs(factor - 1) > 1e-9)
        return StepTitle{"Scale " + name + " on the surface", "× " + number_text(factor)};
    const double was = before.parameters.clearance, is = after.parameters.clearance;
    constexpr double least_lift = 1e-9; // a slide along its own axes lifts by rounding
    if (std::abs(was - is) > least_lift)
        return StepTitle{(is > was ? "Lift " : "Lower ") + name, "clearance " + in_metres(is)};
    constexpr double least_deg = 1e-6;
    if (const double angle = turn_deg(met, by); std::abs(angle) > least_deg)
        return StepTitle{"Turn " + name + " on the surface", in_degrees(angle)};
    return StepTitle{"Slide " + name,
                     met.then.empty() ? std::string() : in_metres(way_of(met, by))};
}

} // namespace trivar
