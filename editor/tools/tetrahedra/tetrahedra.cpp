// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedra.h"

#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"
#include "core/rays/nearest_face.h"
#include "core/tetrahedra/pulled_layer.h"
#include "core/tetrahedra/pulling.h"
#include "core/tetrahedra/tetrahedra_layers.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/helpers.h"
#include "editor/hands/select.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/hands/viewport_input.h"
#include "editor/picture/tetrahedra_picture.h"
#include "editor/picture/volume_picture.h"
#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// Returns how far a pull by 1 moves the point in its middle. The functions there mix control points
// of which the ball moves some less, so that it is less than 1.
double carried_by(TetrahedraPull pull, const TetrahedraShape& shape, const SimplexVolume& volume)
{
    constexpr double least = 0.2; // what hangs on less is not forced along
    const TetrahedraRefinement* refinement = nullptr;
    int number = 0;
    for (const TetrahedraEdit& edit : shape.edits)
        if (edit.refinement && ++number == pull.layer) refinement = &*edit.refinement;
    pull.by = {1, 0, 0};
    SimplexVolume moved = volume;
    moved.displacements = change_by(pull, volume, refinement);
    return std::clamp(evaluate(moved, pull.at).position.x - pull.at.x, least, 1.0);
}

} // namespace

const Tool* TetrahedraTool::inner() const
{
    if (by_ == By::points) return &points_;
    return by_ == By::knots ? &clouds_ : nullptr;
}

PartsTool* TetrahedraTool::parts()
{
    return inner() ? inner()->parts() : nullptr;
}

ToolState TetrahedraTool::state() const
{
    ToolState out{.busy = gesture_.going(), .takes_wheel = gesture_.going()};
    if (inner()) out = inner()->state();
    out.mode = static_cast<int>(by_) + 5 * ((clouds_.picks() + points_.layer()) % 10000);
    return out;
}

void TetrahedraTool::begin(Session& session)
{
    if (session.selected.size() != 1) return;
    if (const Id id = tetrahedra_holding(session, session.selected); id != 0) session.selected = id;
}

double TetrahedraTool::radius(const Session& session) const
{
    return by_ == By::points ? points_.radius(session)
                             : ball_.radius_in(session, by_ == By::pull ? 0.35 : 0.15);
}

std::optional<TetrahedraTool::Place> TetrahedraTool::place_under(const Session& session,
                                                                 const ViewportInput& input) const
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume) return {};
    const Ray ray = ray_through(session.view.camera, input.mouse);
    double nearest = 1e300;
    for (const Id id : with_contents(session.document(), {volume->id})) {
        const auto shown = session.evaluated().objects.find(id);
        if (shown == session.evaluated().objects.end()) continue;
        for (const Part& part : shown->second->parts)
            if (!part.drawn_from_tiles())
                nearest =
                    nearest_face(*part.mesh(), part.to_world, ray.origin, ray.direction, nearest);
    }
    if (nearest > 1e299) return {};
    const glm::dvec3 world = ray.origin + ray.direction * nearest;
    const glm::dvec3 inside(glm::inverse(volume->tetrahedra_to_world) * glm::dvec4(world, 1));
    const std::optional<glm::dvec3> rest = inverse(*volume->tetrahedra->volume, inside, 1e-6);
    if (!rest) return {};
    return Place{world, *rest};
}

TetrahedraEdit TetrahedraTool::edit_at(const TetrahedraShape& shape, const Place& place,
                                       const Session& session) const
{
    const double r = radius(session);
    if (by_ == By::crease)
        return {.crease = TetrahedraCrease{{place.rest}, r, std::min(depth_, shape.degree)}};
    if (by_ == By::refine)
        return {.refinement = TetrahedraRefinement{{place.rest}, r, rounded(r / 2, 2)}};
    return {.pull = TetrahedraPull{.layer = pulled_layer(shape, place.rest, r),
                                   .at = place.rest,
                                   .radius = r,
                                   .decay = ball_.decay,
                                   .guard = ball_.guard}};
}

void TetrahedraTool::use(Session& session, const ViewportInput& input)
{
    if (Tool* tool = inner()) return tool->use(session, input);
    if (gesture_) {
        if (!shown_tetrahedra(session, gesture_->object)) return cancel(session);
        return go_on(session, input);
    }
    at_.reset();
    if (input.hovered || input.pressed) at_ = place_under(session, input);
    if (!input.pressed || session.committing()) return;
    if (!at_)
        if (const Id id = tetrahedra_holding(session, input.under); id != 0) {
            session.selected = id;
            at_ = place_under(session, input);
        }
    if (at_)
        start(session, input);
    else
        select_by_click(session, input.under);
}

void TetrahedraTool::start(Session& session, const ViewportInput& input)
{
    const EvaluatedObject& volume = *shown_tetrahedra(session, session.selected);
    const TetrahedraShape& shape = *tetrahedra_shape(session.document(), volume.id);
    gesture_.begin({volume.id, edit_at(shape, *at_, session), at_->world,
                    glm::inverse(glm::dmat3(volume.tetrahedra_to_world))},
                   input);
    take_hold(session);
}

void TetrahedraTool::take_hold(const Session& session)
{
    const EvaluatedObject* volume = shown_tetrahedra(session, gesture_->object);
    const TetrahedraShape* shape = tetrahedra_shape(session.committed(), gesture_->object);
    if (gesture_->edit.pull && volume && shape)
        gesture_->carried = carried_by(*gesture_->edit.pull, *shape, *volume->tetrahedra->volume);
}

// In the plane through the grabbed point that the camera faces.
void TetrahedraTool::pull_on(const Camera& camera, const ViewportInput& input)
{
    const glm::dvec3 by =
        dragged_across(camera, gesture_->grabbed, gesture_.from_px(), input.mouse);
    gesture_->edit.pull->by = gesture_->to_volume * by / gesture_->carried;
}

void TetrahedraTool::draw_on(const Session& session, const ViewportInput& input)
{
    const std::optional<Place> place = place_under(session, input);
    if (!place) return;
    TetrahedraEdit& edit = gesture_->edit;
    std::vector<glm::dvec3>& places = edit.crease ? edit.crease->places : edit.refinement->places;
    const double r = edit.crease ? edit.crease->radius : edit.refinement->radius;
    constexpr std::size_t most_places = 500;
    if (glm::distance(places.back(), place->rest) > 0.4 * r && places.size() < most_places)
        places.push_back(place->rest);
}

void TetrahedraTool::go_on(Session& session, const ViewportInput& input)
{
    gesture_.follow(input);
    std::optional<TetrahedraPull>& pull = gesture_->edit.pull;
    if (input.wheel != 0 && pull) {
        pull->radius = ball_.radius = rounded(pull->radius * std::pow(radius_step, input.wheel), 3);
        take_hold(session);
    }
    if (!pull)
        draw_on(session, input);
    else if (gesture_.moved())
        pull_on(session.view.camera, input);
    gesture_.go_on(session, input, [&]() -> std::optional<Command> {
        if (pull && pull->by == glm::dvec3(0)) return {};
        return EditTetrahedra{gesture_->object, gesture_->edit};
    });
}

void TetrahedraTool::cancel(Session& session)
{
    points_.cancel(session);
    clouds_.cancel(session);
    gesture_.cancel(session);
}

bool TetrahedraTool::resize(Session& session, double factor)
{
    ball_.radius = rounded(radius(session) * factor, 3);
    return true;
}

void TetrahedraTool::take_keys(Session& session)
{
    if (inner()) inner()->take_keys(session);
}

Helpers TetrahedraTool::helpers(const Session& session, const ui::Theme& theme) const
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume) return {};
    Helpers out;
    const auto add = [&](std::vector<gpu::Line> lines) {
        std::ranges::move(lines, std::back_inserter(out.lines));
    };
    if (inner()) {
        const int layer = by_ == By::knots ? 0 : points_.layer();
        add(domain_lines(*volume, static_cast<std::size_t>(layer), theme.color, theme.line(1)));
        Helpers own = inner()->helpers(session, theme);
        add(std::move(own.lines));
        out.veils = std::move(own.veils);
    }
    const TetrahedraPull* pull = points_.pull();
    if (gesture_ && gesture_->edit.pull) {
        pull = &*gesture_->edit.pull;
        const glm::dvec3 now = evaluate(*volume->tetrahedra->volume, pull->at).position;
        out.veils = {ball_veil(glm::dvec3(volume->tetrahedra_to_world * glm::dvec4(now, 1)),
                               pull->radius * length_of(*volume), theme.color)};
    }
    if (pull) add(support_lines(*volume, *pull, theme.color, theme.line(1)));
    return out;
}

} // namespace trivar
