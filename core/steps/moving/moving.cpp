// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/moving/moving.h"

#include "core/document/parameters.h"
#include "core/placement/placement.h"
#include "core/stages/bending.h"
#include "core/stages/reaching.h"
#include "core/stages/standing.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// Adds the notices of the pose that the shape does not have already.
void tell_of_pose(Stage& stage, const Shape& posed)
{
    const auto add = [](std::vector<std::string>& out, const std::vector<std::string>& told,
                        std::size_t known) {
        out.insert(out.end(), told.begin() + static_cast<long>(known), told.end());
    };
    add(stage.notices, posed.notices, stage.shape->notices.size());
    add(stage.lacks, posed.lacks, stage.shape->lacks.size());
}

void tell_of_travel(Stage& stage)
{
    if (stage.walk && !stage.walk->trouble.empty()) stage.notices.push_back(stage.walk->trouble);
    if (stage.walk && !stage.walk->remark.empty()) stage.notices.push_back(stage.walk->remark);
    if (stage.journey && stage.journey->travel().speed != 0 && !stage.journey->has_room())
        stage.notices.emplace_back(
            "it fills its whole stroke and has no room to travel; reduce its fill");
}

// Moves the embedding of a box along its volume.
Embedding shifted(Embedding box, const Lattice& volume, double shift_u)
{
    if (shift_u == 0) return box;
    box.to_uvw = glm::translate(glm::dmat4(1), {shift_u, 0, 0}) * box.to_uvw;
    box.to_rest = volume.rest * box.to_uvw;
    return box;
}

// Collects the parts of all members, each shifted to its place, in one volume.
std::vector<Part> parts_of(const Stage& at_rest, const std::vector<Member>& members,
                           const Ref<Lattice>& volume, const glm::dmat3& turned)
{
    std::vector<Part> out;
    int number = 0; // of the member
    const auto lay = [&](Part part, const Embedding& embedding) {
        part.key.member = number;
        out.push_back(in_volume(part, embedding, volume, sorted_into(*volume, part, embedding)));
    };
    for (const auto& [posed, place] : members) {
        const Embedding box = shifted(at_rest.placement->embedding, *volume, place.shift_u);
        if (place.hidden) {
            ++number;
            continue;
        }
        if (posed)
            for (const StandingMesh& each : standing(*posed, turned))
                lay(each.part, embedded(box, each.to_box));
        else if (place.shift_u != 0)
            for (const Part& part : at_rest.parts)
                lay(part, shifted(part.bent->embedding, *volume, place.shift_u));
        else
            for (const Part& part : at_rest.parts) {
                out.push_back(part);
                out.back().key.member = number;
            }
        ++number;
    }
    return out;
}

// Collects the curves of all members in the same way.
std::vector<CurvePart> curves_of(const Stage& at_rest, const std::vector<Member>& members,
                                 const Ref<Lattice>& volume, const glm::dmat3& turned)
{
    std::vector<CurvePart> out;
    for (std::size_t m = 0; m < members.size(); ++m) {
        const auto& [posed, place] = members[m];
        if (place.hidden) continue;
        const Embedding box = shifted(at_rest.placement->embedding, *volume, place.shift_u);
        for (StandingCurves& each : standing_curves(posed ? *posed : *at_rest.shape, turned)) {
            Part& points = each.part.points;
            points.key.member = static_cast<int>(m);
            const Embedding lies = embedded(box, each.to_box);
            points = in_volume(points, lies, volume, sorted_into(*volume, points, lies));
            out.push_back(std::move(each.part));
        }
    }
    return out;
}

} // namespace

Ref<Stage> MovingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const Object& o = input.object;
    const Ref<Shape> posed =
        posing_(before->shape, o.playing, input.seconds_since(o.playing.start_frame));
    if (before->placement) return gone(before, posed, input);
    const bool feet_on_nothing = !o.stroke && o.playing.foot_lock && !o.playing.clip.empty();
    const FreeKey key{before, posed, to_world(input.document, input.id), feet_on_nothing};
    return free_(key, [&] {
        Stage stage = *before;
        stage.own_to_world = key.to_world;
        stage.own_parts = parts_in_model(*posed);
        for (Part part : stage.own_parts) {
            part.to_world = key.to_world * part.to_world;
            stage.parts.push_back(std::move(part));
        }
        for (const StandingCurves& each : standing_curves(*posed, glm::dmat3(1))) {
            stage.curves.push_back(each.part);
            stage.curves.back().points.to_world = key.to_world * each.to_box;
        }
        tell_of_pose(stage, *posed);
        if (feet_on_nothing)
            stage.notices.emplace_back(
                "foot lock has no effect without a stroke; place the object on one");
        if (!stage.rejected.empty()) stage.notices.push_back(stage.rejected);
        return make_ref(std::move(stage));
    });
}

Ref<Journey> MovingStep::journey(const Ref<Stage>& laid, const Object& object)
{
    const Travel& travel = object.travel;
    if (travel.speed == 0 && travel.followers == 0) return nullptr;
    return journeys_({laid, travel}, [&] {
        return std::make_shared<const Journey>(travel, object.stroke->parameters,
                                               laid->placement->contact);
    });
}

Ref<Stage> MovingStep::gone(const Ref<Stage>& before, const Ref<Shape>& posed,
                            const StepInput& input)
{
    const Object& o = input.object;
    const PlacementParameters& parameters = o.stroke->parameters;
    const glm::dmat3 turned(o.transform.matrix());
    const Ref<Shape>& shape = before->shape;
    const double playing_s = input.seconds_since(o.playing.start_frame);
    TravelKey key{before, posed, {}, journey(before, o), nullptr};
    key.walk = walks_(shape, o.playing, before, key.journey, parameters, turned);
    const auto clip = std::ranges::find(shape->model->clips, o.playing.clip, &Clip::name);
    const bool plays = clip != shape->model->clips.end();
    posing_.keep(3 * static_cast<std::size_t>(o.travel.followers + 2));
    const double travelling_s = input.seconds_since(o.travel.start_frame);
    for (int k = 0; k <= o.travel.followers; ++k) {
        Member member{nullptr, key.journey ? key.journey->at(travelling_s, k) : Journey::Place{}};
        Playing playing = o.playing;
        if (plays) playing.offset += k * o.travel.phase * (clip->end_s - clip->begin_s);
        if (plays && key.walk && key.walk->trouble.empty())
            member.posed = posing_.at(
                shape, *clip, key.walk->clip_time_s(playing, member.place.gone_u), key.walk->gait);
        else if (plays)
            member.posed = posing_(shape, playing, playing_s);
        key.members.push_back(std::move(member));
    }
    return gone_(key, [&] {
        Stage stage = *before;
        stage.journey = key.journey;
        stage.walk = key.walk;
        Ref<Lattice> volume(before->placement, &before->placement->volume);
        if (key.journey) {
            std::vector<Journey::Place> places;
            for (const Member& member : key.members) places.push_back(member.place);
            volume = reaching(volume, *key.journey, parameters, places);
        }
        stage.parts = parts_of(*before, key.members, volume, turned);
        const bool at_rest = key.members == std::vector<Member>{{nullptr, {}}};
        if (!at_rest) stage.curves = curves_of(*before, key.members, volume, turned);
        tell_of_pose(stage, *posed);
        tell_of_travel(stage);
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
