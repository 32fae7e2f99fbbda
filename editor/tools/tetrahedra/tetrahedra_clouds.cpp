// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedra_clouds.h"

#include "core/commands/edits/edits.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/tetrahedra/cloud_room.h"
#include "editor/hands/select.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

constexpr double knot_reach_px = 10; // of the mouse, at scale 1

} // namespace

glm::dvec3 TetrahedraClouds::world(const glm::dvec3& p) const
{
    return to_world_ * glm::dvec4(p, 1);
}

void TetrahedraClouds::follow(const Session& session)
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume) {
        if (vertex_) pick_none();
        object_ = 0;
        basis_ = nullptr;
        return;
    }
    to_world_ = volume->tetrahedra_to_world;
    axes_ = axes_of(*volume);
    const Ref<SimplexBasis<3>>& basis = volume->tetrahedra->volume->layers.front();
    if (object_ == volume->id && basis_ == basis) return;
    if (object_ != volume->id) pick_none();
    object_ = volume->id;
    basis_ = basis;
    if (!vertex_) return;
    const bool there = *vertex_ < static_cast<int>(domain().vertex_count()) &&
                       domain().vertex(*vertex_) == at_ && knot_ <= domain().degree;
    if (!there) return pick_none();
    pick(*vertex_, knot_);
}

void TetrahedraClouds::pick_none()
{
    ++picks_;
    vertex_.reset();
}

void TetrahedraClouds::pick(int vertex, int knot)
{
    ++picks_;
    vertex_ = vertex;
    knot_ = knot;
    at_ = domain().vertex(vertex);
    cells_ = cells_round(domain(), vertex);
    room_ = cloud_room(domain(), cells_);
    region_.clear();
    if (knot == 0) return;
    double shortest = 1e300; // edge: beyond the border there is no end to where a knot may be
    for (const int c : cells_)
        for (const int v : domain().cells[static_cast<std::size_t>(c)])
            if (v != vertex) shortest = std::min(shortest, glm::distance(domain().vertex(v), at_));
    region_ = knot_region(domain(), cells_, vertex, knot, 0.8 * shortest);
}

void TetrahedraClouds::use(Session& session, const ViewportInput& input)
{
    follow(session);
    if (gesture_) {
        const SimplexDomain<3>& was = before_->domain();
        if (object_ == 0 || !vertex_ || domain().cells != was.cells) return cancel(session);
        gesture_.go_on(session, input, [&] { return wanted(); });
        return;
    }
    hovered_.reset();
    hovered_knot_ = 0;
    const Camera& camera = session.view.camera;
    if (object_ == 0) {
        if (input.pressed) {
            const Id id = tetrahedra_holding(session, input.under);
            select_by_click(session, id != 0 ? id : input.under);
        }
        return;
    }
    if (const auto kind = std::exchange(grabbing_, std::nullopt); kind && vertex_) {
        return begin(input, camera, {}, *kind);
    }
    if (!input.hovered && !input.pressed) return;
    double distance = knot_reach_px * input.scale;
    const auto is_nearest = [&](const glm::dvec3& p) {
        const PicturePoint seen = project(camera, world(p));
        const double far = glm::distance(seen.p_px, input.mouse);
        if (seen.depth_world <= 0 || far >= distance) return false;
        distance = far;
        return true;
    };
    for (int j = 1; vertex_ && j <= domain().degree; ++j)
        if (is_nearest(domain().knot(*vertex_, j))) hovered_knot_ = j;
    if (hovered_knot_ == 0)
        for (std::size_t v = 0; v < domain().vertex_count(); ++v)
            if (is_nearest(domain().vertex(static_cast<int>(v)))) hovered_ = static_cast<int>(v);
    if (hovered_ || hovered_knot_ != 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!input.pressed || session.committing()) return;
    if (hovered_knot_ != 0) {
        pick(*vertex_, hovered_knot_);
        begin(input, camera, {Grip::center, 0}, MotionKind::move);
    } else if (hovered_) {
        pick(*hovered_, 0);
    } else {
        pick_none();
        if (tetrahedra_holding(session, input.under) != object_)
            select_by_click(session, input.under);
    }
}

bool TetrahedraClouds::grab(Session& session, MotionKind kind)
{
    follow(session);
    grabbing_.reset();
    if (object_ == 0) return false;
    if (!vertex_ || (kind == MotionKind::move && knot_ == 0) || kind == MotionKind::rotate)
        session.notices.say(ui::NoticeKind::warning, "No knot is selected",
                            "Click a vertex of the domain, then one of its knots. A knot can be "
                            "moved, and a cloud scaled.",
                            of_a_step);
    else if (!session.committing())
        grabbing_ = kind;
    return true;
}

void TetrahedraClouds::begin(const ViewportInput& input, const Camera& camera,
                             const GizmoHandle& handle, MotionKind kind)
{
    before_ = basis_;
    stopped_ = false;
    cloud_ = {};
    const glm::dvec3 from = world(kind == MotionKind::move ? domain().knot(*vertex_, knot_) : at_);
    gesture_.begin(kind, object_, {from, axes_}, handle, camera, input);
}

Command TetrahedraClouds::wanted()
{
    const Motion motion = gesture_->motion();
    const SimplexDomain<3>& was = before_->domain();
    if (motion.kind == MotionKind::scale) {
        const double factor = std::max(0.0, motion.factors.x);
        double share = 1;
        for (int j = 1; j <= was.degree; ++j)
            share = std::min(share, allowed_share(was, cells_, *vertex_, j,
                                                  (was.knot(*vertex_, j) - at_) * (factor - 1)));
        stopped_ = share < 1;
        cloud_ = {.at = at_, .factor = 1 + share * (factor - 1)};
    } else {
        const glm::dvec3 by =
            glm::round(glm::inverse(glm::dmat3(to_world_)) * (axes_ * motion.offset) * 1e9) / 1e9;
        const double share = allowed_share(was, cells_, *vertex_, knot_, by);
        stopped_ = share < 1;
        cloud_ = {.at = at_, .knot = knot_, .by = by * share};
    }
    return EditTetrahedra{object_, {.cloud = cloud_}};
}

void TetrahedraClouds::cancel(Session& session)
{
    gesture_.cancel(session);
}

void TetrahedraClouds::take_keys(Session& session)
{
    if (gesture_ && gesture_.take_keys()) gesture_.finish(session, [&] { return wanted(); });
}

} // namespace trivar
