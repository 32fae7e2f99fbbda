// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/following.h"

#include "core/stages/bending.h"

#include <map>

namespace trivar {
namespace {

// Carries parts in volumes with their hosts, each volume once.
class CarriedParts {
public:
    CarriedParts(const Stage& before, const Stage& after, const glm::dmat4& to_world)
        : to_world_(to_world)
    {
        if (before.placement)
            known_[&before.placement->volume] = {after.placement, &after.placement->volume};
    }
    Part operator()(Part part)
    {
        if (!part.bent) {
            part.to_world = to_world_ * part.to_world;
            return part;
        }
        Ref<Lattice>& volume = known_[part.bent->volume.get()];
        if (!volume) volume = make_ref(mapped(*part.bent->volume, to_world_));
        Embedding embedding = part.bent->embedding;
        embedding.to_rest = to_world_ * embedding.to_rest;
        return in_volume(part, embedding, volume, sorted_into(*volume, part, embedding),
                         part.bent->inner);
    }

private:
    glm::dmat4 to_world_;
    std::map<const Lattice*, Ref<Lattice>> known_;
};

} // namespace

Ref<ShapedVolume> carried(const ShapedVolume& shaped, const glm::dmat4& to_world)
{
    ShapedVolume out = shaped;
    out.placement = make_ref(carried(*shaped.placement, to_world));
    LaidVolume laid = *shaped.volume;
    laid.volume = make_ref(mapped(*laid.volume, to_world));
    laid.as_laid = make_ref(mapped(*laid.as_laid, to_world));
    out.volume = make_ref(std::move(laid));
    return make_ref(std::move(out));
}

Placement carried(Placement placement, const glm::dmat4& to_world)
{
    const auto at = [&](const glm::dvec3& p) { return glm::dvec3(to_world * glm::dvec4(p, 1)); };
    placement.volume = mapped(std::move(placement.volume), to_world);
    for (glm::dvec3& p : placement.contact.points) p = at(p);
    for (std::vector<glm::dvec3>& line : placement.strip)
        for (glm::dvec3& p : line) p = at(p);
    for (StripNode& node : placement.nodes) node.p_world = at(node.p_world);
    placement.embedding.to_rest = to_world * placement.embedding.to_rest;
    const double scale = glm::length(glm::dvec3(to_world[0]));
    PlacementReport& report = placement.report;
    for (double* length :
         {&report.length_world, &report.width_world, &report.height_world, &report.largest_gap})
        *length *= scale;
    return placement;
}

Ref<Stage> FollowingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const Ref<StrokeMotion> stroke_motion = (*stroke_motions_)(input);
    if (!stroke_motion) return before;
    return known_({before, stroke_motion}, [&] {
        Stage stage = *before;
        stage.stroke_motion = stroke_motion;
        stage.notices.insert(stage.notices.end(), stroke_motion->notices.begin(),
                             stroke_motion->notices.end());
        if (!stroke_motion->shown) {
            stage.parts.clear();
            stage.curves.clear();
            stage.own_parts.clear();
            return make_ref(std::move(stage));
        }
        if (!stage.placement) return make_ref(std::move(stage));
        stage.own_parts = stage.parts;
        stage.own_to_world = stroke_motion->to_world;
        if (!stroke_motion->moved()) return make_ref(std::move(stage));
        if (stage.shaped) {
            stage.shaped = carried(*stage.shaped, stroke_motion->to_world);
            stage.placement = stage.shaped->placement;
        } else
            stage.placement = make_ref(carried(*stage.placement, stroke_motion->to_world));
        CarriedParts carry(*before, stage, stroke_motion->to_world);
        for (Part& part : stage.parts) part = carry(std::move(part));
        for (CurvePart& curve : stage.curves) curve.points = carry(std::move(curve.points));
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
