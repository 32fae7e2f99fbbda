// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/laying.h"

#include "core/base/rejected.h"
#include "core/document/band.h"
#include "core/document/parameters.h"
#include "core/placement/journey.h"
#include "core/placement/round.h"
#include "core/placement/view.h"
#include "core/stages/standing.h"
#include "core/stages/told_steps.h"

namespace trivar {
namespace {

Box box_of(const Shape& shape, const glm::dmat3& turned, const std::optional<glm::dvec3>& lattice)
{
    Box box;
    if (lattice)
        for (const glm::dvec3& corner : Box{-*lattice / 2.0, *lattice / 2.0}.corners())
            box.add(turned * corner);
    for (const Shape::NodeMesh& hung : shape.meshes)
        box.add(bounding_box(*hung.mesh(), glm::dmat4(turned) * hung.to_model));
    for (const Shape::NodeCurves& hung : shape.curves)
        box.add(bounding_box(*hung.curves->points, glm::dmat4(turned) * hung.to_model));
    return box;
}

// Finds the band that a placement goes round, if that object still exists and lies on no stroke.
std::optional<Band> band_of(const Document& document, const PlacementStep& step)
{
    if (!step.round || step.onto.empty()) return {};
    const Object& base = object(document, step.onto.front());
    if (base.stroke) return {};
    return band_round(base.source, step.round->level, to_world(document, step.onto.front()));
}

// Places round the body where the plane of the step cuts it, in the present shape of the body.
Placement round_where_cut(const Document& document, const PlacementStep& step,
                          const std::vector<Support>& supports, const Box& box, Timings& timings)
{
    if (step.onto.empty())
        throw Rejected("what it goes round is gone; place it again or remove it from its stroke");
    const Id around = step.onto.front();
    if (object(document, around).stroke)
        throw Rejected(
            "what it goes round lies on a stroke itself now; place it again or remove it "
            "from its stroke");
    const glm::dmat4 to_world = trivar::to_world(document, around);
    const glm::dmat3 linear(to_world);
    if (!(std::abs(glm::determinant(linear)) > 0))
        throw Rejected("what it goes round is flat; give it a size");
    const glm::dvec3 own = glm::normalize(*step.round->normal);
    SectionPlane plane;
    plane.p = glm::dvec3(to_world * glm::dvec4(own * step.round->level, 1));
    plane.normal = glm::normalize(glm::transpose(glm::inverse(linear)) * own);
    plane.first = linear[0];
    std::vector<SectionBody> bodies;
    for (const Support& each : supports)
        bodies.push_back({&*mesh_of(each.part, timings), each.part.to_world});
    return place_round(Section(bodies, plane), step.parameters, box);
}

bool moves(const EvaluatedObject& object)
{
    return object.journey && object.journey->travel().speed != 0;
}

// Holds the objects that a stroke may fall on, and which of them travel.
struct Supports {
    std::vector<Support> all, still;
    std::vector<Ref<EvaluatedObject>> travelling;
};
Supports supports_of(const PlacementStep& step, const std::map<Id, Ref<EvaluatedObject>>& done,
                     const GroundPlane& ground)
{
    Supports out;
    if (step.parameters.on_ground && !step.round)
        if (const auto under = ground.under(step.sketch, glm::dmat4(1)))
            out.still.push_back(out.all.emplace_back(*under));
    for (const Id lower : step.onto) {
        const auto found = done.find(lower);
        if (found == done.end()) continue;
        const EvaluatedObject& object = *found->second;
        for (const Part& part : object.parts) {
            out.all.push_back(support_of(object, part, object.own_to_world));
            if (!moves(object)) out.still.push_back(out.all.back());
        }
        if (moves(object) && !object.parts.empty()) out.travelling.push_back(found->second);
    }
    return out;
}

// Says whether a box and the volume overlap in the picture in which the stroke was drawn; its rays
// meet nothing elsewhere. A box that reaches behind the camera always counts as overlapping.
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

// A travelling support counts only in frames in which it overlaps the strip in the picture, so that
// a stroke is not laid again for objects that pass elsewhere.
bool travels_through(const Supports& supports, const Stage& without, const Camera& camera)
{
    return !without.placement ||
           std::ranges::any_of(supports.travelling, [&](const Ref<EvaluatedObject>& each) {
               return in_the_way(*each->bounds, *without.placement, camera);
           });
}

} // namespace

Ref<Stage> LayingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const Object& o = input.object;
    if (!o.stroke) return before;
    const glm::dmat3 turned(o.transform.matrix());
    std::optional<glm::dvec3> lattice;
    if (const auto* shape = std::get_if<LatticeShape>(&o.source)) lattice = shape->size;
    if (const Ref<StrokeMotion> stroke_motion = (*stroke_motions_)(input)) {
        PlacementStep step = *o.stroke;
        step.sketch = stroke_motion->sketch;
        step.attach.reset(); // hosts do not change how it lies
        return laid_on({before, turned, lattice, std::move(step), stroke_motion->supports}, input);
    }
    const Supports supports = supports_of(*o.stroke, input.done, ground_);
    const auto laid = [&](const std::vector<Support>& on) {
        return laid_on({before, turned, lattice, *o.stroke, on}, input);
    };
    if (supports.travelling.empty() || supports.still.empty()) return laid(supports.all);
    const Ref<Stage> without = laid(supports.still);
    return travels_through(supports, *without, o.stroke->sketch.camera) ? laid(supports.all)
                                                                        : without;
}

Ref<Stage> LayingStep::laid_on(Stroke stroke, const StepInput& input)
{
    ShapedStroke key{std::move(stroke), {}};
    // The edits of a lattice shape its box
    if (!key.stroke.lattice) key.shaping = input.object.shaping;
    return laid_(key, [&] {
        Stroke of_whole = key.stroke; // incisions that open do not change how it lies
        if (of_whole.before->uncut) of_whole.before = of_whole.before->uncut;
        const Landing fallen = fallen_(of_whole, [&] { return fall(of_whole, input); });
        Stage stage = *key.stroke.before;
        stage.lies_on = fallen.scene;
        stage.supports = make_ref(key.stroke.supports);
        stage.rejected = fallen.rejected;
        if (!fallen.placement) return make_ref(std::move(stage));
        if (!key.shaping.empty())
            stage.shaped = timed(input.timings, "shape", [&] {
                return shaper_(fallen.placement, key.shaping, input.progress);
            });
        stage.placement = stage.shaped ? stage.shaped->placement : fallen.placement;
        bend(stage, key.stroke.turned);
        const std::vector<std::string> told = stage.placement->report.all_notices();
        stage.notices.insert(stage.notices.end(), told.begin(), told.end());
        if (stage.shaped) tell_of_steps(*stage.shaped, stage.notices);
        return make_ref(std::move(stage));
    });
}

LayingStep::Landing LayingStep::fall(const Stroke& stroke, const StepInput& input)
{
    const Shape& shape = *stroke.before->shape;
    const PlacementStep& step = stroke.step;
    try {
        if (shape.empty() && !stroke.lattice)
            throw Rejected("the object is empty, so there is nothing to place");
        if (stroke.supports.empty() && !step.parameters.on_ground)
            throw Rejected("everything this object lay on is gone; place it again or remove it "
                           "from its stroke");
        const std::optional<Band> band = band_of(input.document, step);
        const bool cut = step.round && step.round->normal;
        if (step.round && !cut && !band)
            throw Rejected(
                "what it goes round is no longer a free-standing cylinder, sphere, torus "
                "or Moebius band; place it again or remove it from its stroke");
        const Box box = box_of(shape, stroke.turned, stroke.lattice);
        if (cut)
            return {make_ref(timed(input.timings, "volume",
                                   [&] {
                                       return round_where_cut(input.document, step, stroke.supports,
                                                              box, input.timings);
                                   })),
                    nullptr,
                    {}};
        if (step.round)
            return {make_ref(timed(input.timings, "volume",
                                   [&] { return place_round(*band, step.parameters, box); })),
                    nullptr,
                    {}};
        const Ref<RayScene> scene = scene_of(stroke.supports, input);
        return {
            make_ref(place(step.sketch, step.parameters, box, *scene, input.timings)), scene, {}};
    } catch (const Rejected& error) {
        return {nullptr, nullptr, error.what()};
    }
}

Ref<RayScene> LayingStep::scene_of(const std::vector<Support>& supports, const StepInput& input)
{
    return scenes_(supports, [&] {
        std::vector<RayScene::Entry> entries;
        entries.reserve(supports.size());
        for (const Support& support : supports)
            entries.push_back(
                {input.ray_meshes(mesh_of(support.part, input.timings), input.timings),
                 support.part.to_world, support.id});
        return timed(input.timings, "rays",
                     [&] { return std::make_shared<const RayScene>(std::move(entries)); });
    });
}

void LayingStep::bend(Stage& stage, const glm::dmat3& turned)
{
    const Embedding& embedding = stage.placement->embedding;
    const Ref<Lattice> volume(stage.placement, &stage.placement->volume);
    bending_.begin();
    for (const StandingMesh& each : standing(*stage.shape, turned))
        stage.parts.push_back(bending_(each.part, embedded(embedding, each.to_box), volume));
    for (const StandingCurves& each : standing_curves(*stage.shape, turned)) {
        const Embedding lies = embedded(embedding, each.to_box);
        stage.curves.push_back({each.part.curves, bending_(each.part.points, lies, volume)});
    }
    bending_.end();
}

} // namespace trivar
