// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/laying.h"

#include "core/base/rejected.h"
#include "core/ffd/prolong.h"
#include "core/placement/view.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// Enough for undo and redo of a step or two without computing anything.
constexpr std::size_t kept_results = 3;

Box box_of(const Shape& shape, const glm::dmat3& turned)
{
    Box box;
    for (const Shape::Hung& hung : shape.meshes)
        box.add(bounding_box(*hung.mesh(), glm::dmat4(turned) * hung.to_model));
    return box;
}

// The shape's meshes before they are laid, and from each to the box of the model.
struct Standing {
    Part part;
    glm::dmat4 to_box;
};
std::vector<Standing> standing(const Shape& shape, const glm::dmat3& turned)
{
    std::vector<Standing> out;
    for (const Shape::Hung& hung : shape.meshes) {
        Standing each{{.rest = hung.rest, .posed = hung.posed, .bounds = hung.bounds},
                      glm::dmat4(turned) * hung.to_model};
        if (glm::determinant(glm::dmat3(each.to_box)) < 0) { // turn the faces round once, before
            each.part = {.rest = make_ref(transformed(*hung.mesh(), each.to_box))};
            each.part.bounds = bounding_box(*each.part.rest);
            each.to_box = glm::dmat4(1);
        }
        each.part.slot = hung.slot;
        out.push_back(std::move(each));
    }
    return out;
}

Embedding embedded(const Embedding& box, const glm::dmat4& to_box)
{
    return {box.to_uvw * to_box, box.to_rest * to_box};
}

// The box further along its volume.
Embedding shifted(Embedding box, const Lattice& volume, double shift_u)
{
    if (shift_u == 0) return box;
    box.to_uvw = glm::translate(glm::dmat4(1), {shift_u, 0, 0}) * box.to_uvw;
    box.to_rest = volume.rest * box.to_uvw;
    return box;
}

} // namespace

Ref<Lattice> reaching(const Ref<Lattice>& volume, const Journey& journey,
                      const PlacementParameters& p, const std::vector<Journey::Place>& places)
{
    if (volume->displacement.axes[0].closure() != Closure::open) return volume;
    constexpr double slack = 1e-3; // a model's faces lie on its box, give or take a rounding
    double from = 0, to = 1;
    for (const Journey::Place& place : places) {
        if (place.hidden) continue;
        from = std::min(from, p.start + place.shift_u);
        to = std::max(to, p.start + place.shift_u + p.fill);
    }
    if (from >= -1e-9 && to <= 1 + 1e-9) return volume;
    if (journey.rounds()) return make_ref(twice_round(*volume));
    return make_ref(prolonged(*volume, from - slack, to + slack));
}

bool in_the_way(const Box& box, const Placement& placement, const Camera& camera)
{
    const View view(camera);
    glm::dvec2 strip_lo(1e300), strip_hi(-1e300), lo(1e300), hi(-1e300);
    const auto& points = placement.volume.displacement.points; // round the volume
    for (const glm::dvec3& p : points) {
        const glm::dvec2 seen = view.project(p + glm::dvec3(placement.volume.rest[3])).p_px;
        strip_lo = glm::min(strip_lo, seen);
        strip_hi = glm::max(strip_hi, seen);
    }
    for (const glm::dvec3& p : box.corners()) {
        const auto seen = view.project(p);
        if (!(seen.depth_world > 0)) return true;
        lo = glm::min(lo, seen.p_px);
        hi = glm::max(hi, seen.p_px);
    }
    return lo.x <= strip_hi.x && lo.y <= strip_hi.y && hi.x >= strip_lo.x && hi.y >= strip_lo.y;
}

Ref<RayMesh> RayMeshes::operator()(const Ref<Mesh>& mesh, Timings& timings)
{
    Ref<RayMesh>& known = known_[mesh];
    if (!known)
        known = timed(timings, "rays", [&] { return std::make_shared<const RayMesh>(mesh); });
    return known;
}

void RayMeshes::keep_only(const std::set<Ref<Mesh>>& meshes)
{
    std::erase_if(known_, [&](const auto& known) { return !meshes.contains(known.first); });
}

Ref<Laid> Laying::operator()(const Ref<Shape>& shape, const glm::dmat3& turned,
                             const PlacementStep& step, const std::optional<Band>& band,
                             const std::vector<Ref<VolumeEdit>>& shaping,
                             const std::vector<Support>& supports, RayMeshes& ray_meshes,
                             Timings& timings, const Progress& progress)
{
    const auto same_stroke = [&](const Known& k) {
        return k.shape == shape && k.turned == turned && k.supports == supports && k.step == step;
    };
    const auto found = std::ranges::find_if(
        known_, [&](const Known& k) { return k.shaping == shaping && same_stroke(k); });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
        return known_.front().laid;
    }
    const auto unshaped = std::ranges::find_if(known_, same_stroke);
    Known known{shape, turned, step, shaping, supports, nullptr, nullptr};
    Laid laid;
    if (unshaped != known_.end()) {
        laid = *unshaped->laid;
        known.unshaped = unshaped->unshaped;
    } else
        try {
            if (shape->meshes.empty()) throw Rejected("there is no shape to lay down");
            if (supports.empty())
                throw Rejected("everything this object lay on is gone; place it anew or unplace "
                               "it");
            if (step.round && !band)
                throw Rejected("what it goes round is no cylinder, sphere, torus or Moebius band "
                               "that stands free any more; place it anew or unplace it");
            const Box box = box_of(*shape, turned);
            if (step.round)
                known.unshaped = make_ref(timed(
                    timings, "volume", [&] { return place_round(*band, step.parameters, box); }));
            else {
                const Ref<RayScene> scene = scene_of(supports, ray_meshes, timings);
                known.unshaped =
                    make_ref(place(step.sketch, step.parameters, box, *scene, timings));
                laid.scene = scene;
            }
        } catch (const Rejected& error) {
            laid.rejected = error.what();
        }
    if (known.unshaped) {
        laid.shaped = shaping.empty() ? nullptr : timed(timings, "shape", [&] {
            return shaper_(known.unshaped, shaping, progress);
        });
        laid.placement = laid.shaped ? laid.shaped->placement : known.unshaped;
        bend(laid, *shape, turned);
    }
    known.laid = make_ref(std::move(laid));
    known_.insert(known_.begin(), std::move(known));
    if (known_.size() > kept_results) known_.pop_back();
    return known_.front().laid;
}

Ref<RayScene> Laying::scene_of(const std::vector<Support>& supports, RayMeshes& ray_meshes,
                               Timings& timings)
{
    if (scene_ && scene_supports_ == supports) return scene_;
    std::vector<RayScene::Entry> entries;
    entries.reserve(supports.size());
    for (const Support& support : supports)
        entries.push_back({ray_meshes(mesh_of(support.part, timings), timings),
                           support.part.to_world, support.id});
    scene_ = timed(timings, "rays",
                   [&] { return std::make_shared<const RayScene>(std::move(entries)); });
    scene_supports_ = supports;
    return scene_;
}

void Laying::bend(Laid& laid, const Shape& shape, const glm::dmat3& turned)
{
    laid.parts.clear();
    const Embedding& embedding = laid.placement->embedding;
    const Ref<Lattice> volume(laid.placement, &laid.placement->volume);
    bending_.begin();
    for (const Standing& each : standing(shape, turned))
        laid.parts.push_back(bending_(each.part, embedded(embedding, each.to_box), volume));
    bending_.end();
}

Ref<Journey> Laying::journey(const Ref<Laid>& at_rest, const Travel& travel,
                             const PlacementParameters& parameters)
{
    if (!at_rest->placement || (travel.speed == 0 && travel.followers == 0)) return nullptr;
    const auto found = std::ranges::find_if(journeys_, [&](const auto& known) {
        return known.first == at_rest && known.second->travel() == travel;
    });
    if (found != journeys_.end())
        std::rotate(journeys_.begin(), found, found + 1);
    else
        journeys_.insert(journeys_.begin(),
                         {at_rest, std::make_shared<const Journey>(travel, parameters,
                                                                   at_rest->placement->contact)});
    if (journeys_.size() > kept_results) journeys_.pop_back();
    return journeys_.front().second;
}

Ref<Laid> Laying::moved(const Ref<Laid>& at_rest, const std::vector<Member>& members,
                        const glm::dmat3& turned, const Ref<Journey>& journey,
                        const PlacementParameters& parameters, const Ref<Walk>& walk)
{
    if (!at_rest->placement) return at_rest;
    const auto found = std::ranges::find_if(moved_, [&](const Moved& m) {
        return m.at_rest == at_rest && m.members == members && m.journey == journey &&
               m.walk == walk;
    });
    if (found != moved_.end()) {
        std::rotate(moved_.begin(), found, found + 1);
        return moved_.front().laid;
    }
    Laid laid = *at_rest;
    laid.journey = journey;
    laid.walk = walk;
    laid.parts.clear();
    Ref<Lattice> volume(at_rest->placement, &at_rest->placement->volume);
    if (journey) {
        std::vector<Journey::Place> places;
        for (const Member& member : members) places.push_back(member.place);
        volume = reaching(volume, *journey, parameters, places);
    }
    int first_slot = 0; // of the member
    const auto lay = [&](Part part, const Embedding& embedding) {
        part.slot += first_slot;
        laid.parts.push_back(
            in_volume(part, embedding, volume, sorted_into(*volume, part, embedding)));
    };
    for (std::size_t k = 0; k < members.size(); ++k) {
        const auto& [posed, place] = members[k];
        first_slot = static_cast<int>(k * at_rest->parts.size());
        const Embedding box = shifted(at_rest->placement->embedding, *volume, place.shift_u);
        if (place.hidden) continue;
        if (posed)
            for (const Standing& each : standing(*posed, turned))
                lay(each.part, embedded(box, each.to_box));
        else if (place.shift_u != 0)
            for (const Part& part : at_rest->parts)
                lay(part, shifted(part.bent->embedding, *volume, place.shift_u));
        else
            for (const Part& part : at_rest->parts) {
                laid.parts.push_back(part);
                laid.parts.back().slot += first_slot;
            }
    }
    moved_.insert(moved_.begin(), {at_rest, members, journey, walk, make_ref(std::move(laid))});
    if (moved_.size() > kept_results) moved_.pop_back();
    return moved_.front().laid;
}

void Laying::add_meshes(std::set<Ref<Mesh>>& meshes) const
{
    for (const Known& known : known_)
        for (const Support& support : known.supports) meshes.insert(support.part.mesh());
}

} // namespace trivar
