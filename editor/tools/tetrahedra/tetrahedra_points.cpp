// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedra_points.h"

#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"
#include "core/commands/volumes/tetrahedra.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/select.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>
#include <set>

namespace trivar {
namespace {

constexpr double place_reach_px = 11; // of the mouse, at scale 1
constexpr std::size_t most_points = 400000;

// Rounding by a transform that was undone is no digit of what a hand or keys said.
glm::dvec3 tidied(const glm::dvec3& v)
{
    return glm::round(v * 1e9) / 1e9;
}

// Those that can be moved: of a refinement not the ones at its rim.
std::vector<ControlPlace> movable_places(const TetrahedraShape& shape, const SimplexVolume& volume,
                                         int layer)
{
    const SimplexBasis<3>& basis = *volume.layers[static_cast<std::size_t>(layer)];
    if (basis.domain().cells.size() * 10 > most_points) return {};
    std::vector<ControlPlace> out = control_places(basis);
    int number = 0;
    for (const TetrahedraEdit& edit : shape.edits)
        if (edit.refinement && ++number == layer)
            std::erase_if(out, [&](const ControlPlace& place) {
                return share_inside(*edit.refinement, place.rest) <= 0;
            });
    return out;
}

// Places that a cut parts are seen a little apart even where it is closed.
glm::dvec3 seen_place(const SimplexVolume& volume, int layer, const ControlPlace& place)
{
    const auto of = static_cast<std::size_t>(layer);
    glm::dvec3 out(0);
    if (layer > 0)
        out = place_of(volume, of, static_cast<std::size_t>(place.points.front()));
    else {
        for (const int p : place.points) out += place_of(volume, of, static_cast<std::size_t>(p));
        out /= static_cast<double>(place.points.size());
    }
    constexpr double apart = 0.12;
    return out + place.inward * (apart * place.spacing);
}

bool are_alike(const TetrahedraPull& a, const TetrahedraPull& b)
{
    const auto less = [](const glm::dvec3& p, const glm::dvec3& q) {
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::vector<glm::dvec3> p = middles(a), q = middles(b);
    std::ranges::sort(p, less);
    std::ranges::sort(q, less);
    return a.layer == b.layer && p.size() == q.size() &&
           std::ranges::equal(p, q, [&](const glm::dvec3& x, const glm::dvec3& y) {
               return glm::distance(x, y) <= 0.01 * b.radius;
           });
}

} // namespace

void TetrahedraPoints::follow(const Session& session)
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    const TetrahedraShape* shape =
        volume ? tetrahedra_shape(session.document(), volume->id) : nullptr;
    if (!volume || !shape) {
        *this = TetrahedraPoints();
        return;
    }
    const Ref<SimplexVolume>& shown = volume->tetrahedra->volume;
    layer_ = std::clamp(layer_, 0, static_cast<int>(shown->layers.size()) - 1);
    const Ref<SimplexBasis<3>>& basis = shown->layers[static_cast<std::size_t>(layer_)];
    if (object_ != volume->id || basis_ != basis) {
        std::vector<ControlPlace> places = movable_places(*shape, *shown, layer_);
        if (object_ != volume->id || places.size() != places_.size()) chosen_.clear();
        object_ = volume->id;
        basis_ = basis;
        places_ = std::move(places);
        volume_ = nullptr;
    }
    if (volume_ == shown && to_world_ == volume->tetrahedra_to_world) return;
    volume_ = shown;
    to_world_ = volume->tetrahedra_to_world;
    at_world_.clear();
    for (const ControlPlace& place : places_)
        at_world_.emplace_back(to_world_ * glm::dvec4(seen_place(*shown, layer_, place), 1));
}

MotionFrame TetrahedraPoints::frame(const EvaluatedObject& volume) const
{
    glm::dvec3 middle(0);
    for (const int i : chosen_) middle += at_world_[static_cast<std::size_t>(i)];
    return {middle / static_cast<double>(chosen_.size()), axes_of(volume)};
}

std::optional<int> TetrahedraPoints::place_at(const Session& session,
                                              const ViewportInput& input) const
{
    std::optional<int> nearest;
    double distance = place_reach_px * input.scale, depth = 1e300;
    for (std::size_t i = 0; i < at_world_.size(); ++i) {
        const PicturePoint p = project(session.view.camera, at_world_[i]);
        const double far = glm::distance(p.p_px, input.mouse);
        // of two that cover each other the nearer one to the eye
        if (p.depth_world <= 0 || far > distance + 1 ||
            (far > distance - 1 && p.depth_world > depth))
            continue;
        distance = std::min(distance, far);
        depth = p.depth_world;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

void TetrahedraPoints::use(Session& session, const ViewportInput& input, const Manner& manner)
{
    manner_ = manner;
    if (gesture_) {
        if (!selected_tetrahedra(session)) return cancel(session);
        follow(session);
        return go_on(session, input);
    }
    follow(session);
    hovered_.reset();
    hovered_handle_ = {};
    if (object_ == 0) {
        if (input.pressed) {
            const Id id = tetrahedra_holding(session, input.under);
            select_by_click(session, id != 0 ? id : input.under);
        }
        return;
    }
    if (box_px_) {
        if (!input.released && input.down) return;
        if (glm::distance(*box_px_, input.mouse) >= click_slip_px)
            choose_in_box(session, input);
        else if (input.under != 0 && tetrahedra_holding(session, input.under) != object_)
            select_by_click(session, input.under);
        else if (!adds_to_selection())
            chosen_.clear();
        box_px_.reset();
        return;
    }
    if (const auto kind = std::exchange(grabbing_, std::nullopt); kind && !chosen_.empty()) {
        return begin(session, input, {}, *kind);
    }
    if (!input.hovered && !input.pressed) return;
    const EvaluatedObject& volume = *selected_tetrahedra(session);
    if (!chosen_.empty())
        hovered_handle_ = handle_at(
            gizmo_shapes(MotionKind::move, session.view.camera, frame(volume), input.scale),
            glm::vec2(input.mouse), input.scale);
    // The middle of the handles covers a single chosen point: both move it.
    if (hovered_handle_.grip == Grip::none || hovered_handle_.grip == Grip::center)
        hovered_ = place_at(session, input);
    if (hovered_ || hovered_handle_.grip != Grip::none)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!input.pressed || session.committing()) return;
    pressed_ = hovered_;
    if (hovered_ && adds_to_selection())
        choose_at(session, input);
    else if (hovered_handle_.grip != Grip::none)
        begin(session, input, hovered_handle_, MotionKind::move);
    else if (hovered_)
        choose_at(session, input);
    else
        box_px_ = input.mouse;
}

void TetrahedraPoints::choose_at(const Session& session, const ViewportInput& input)
{
    const int place = *hovered_;
    if (adds_to_selection()) {
        if (std::erase(chosen_, place) == 0) chosen_.push_back(place);
        return;
    }
    if (std::ranges::find(chosen_, place) == chosen_.end()) chosen_ = {place};
    begin(session, input, {Grip::center, 0}, MotionKind::move);
}

void TetrahedraPoints::choose_in_box(const Session& session, const ViewportInput& input)
{
    const glm::dvec2 lo = glm::min(*box_px_, input.mouse), hi = glm::max(*box_px_, input.mouse);
    if (!adds_to_selection()) chosen_.clear();
    const std::set<int> before(chosen_.begin(), chosen_.end());
    for (std::size_t i = 0; i < at_world_.size(); ++i) {
        const PicturePoint p = project(session.view.camera, at_world_[i]);
        if (p.depth_world > 0 && glm::all(glm::greaterThanEqual(p.p_px, lo)) &&
            glm::all(glm::lessThanEqual(p.p_px, hi)) && !before.contains(static_cast<int>(i)))
            chosen_.push_back(static_cast<int>(i));
    }
}

bool TetrahedraPoints::choose(const Session& session, PartChoice choice)
{
    follow(session);
    if (object_ == 0 || choice == PartChoice::same) return false;
    std::vector<bool> chosen(places_.size(), choice == PartChoice::all);
    if (choice == PartChoice::others || choice == PartChoice::more)
        for (const int i : chosen_) chosen[static_cast<std::size_t>(i)] = true;
    if (choice == PartChoice::others) chosen.flip();
    if (choice == PartChoice::more) { // those that share a cell with one
        std::set<int> cells;
        for (const int i : chosen_) {
            const std::vector<int>& of = places_[static_cast<std::size_t>(i)].cells;
            cells.insert(of.begin(), of.end());
        }
        for (std::size_t i = 0; i < places_.size(); ++i)
            chosen[i] = chosen[i] || std::ranges::any_of(places_[i].cells, [&](int cell) {
                            return cells.contains(cell);
                        });
    }
    chosen_.clear();
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) chosen_.push_back(static_cast<int>(i));
    return true;
}

bool TetrahedraPoints::grab(Session& session, MotionKind kind)
{
    follow(session);
    grabbing_.reset();
    if (object_ == 0) return false;
    if (chosen_.empty())
        say_no_point_is_selected(session);
    else if (!session.committing())
        grabbing_ = kind;
    return true;
}

std::optional<std::vector<std::string>> TetrahedraPoints::numbers(const Session& session) const
{
    if (chosen_.empty() || object_ != session.selected) return {};
    TetrahedraPull chosen = pull_of(places_, chosen_);
    chosen.layer = layer_;
    std::vector<std::string> names;
    const TetrahedraShape* shape = tetrahedra_shape(session.document(), object_);
    for (std::size_t i = shape ? shape->edits.size() : 0; i-- > 0 && names.empty();) {
        if (!shape->edits[i].pull || !are_alike(*shape->edits[i].pull, chosen)) continue;
        for (const char* part : {"by", "rotation_deg", "factors"})
            for (const char axis : {'x', 'y', 'z'})
                names.push_back(fmt::format("shape.edits.{}.pull.{}.{}", i, part, axis));
    }
    return names;
}

void TetrahedraPoints::begin(const Session& session, const ViewportInput& input,
                             const GizmoHandle& handle, MotionKind kind)
{
    const EvaluatedObject& volume = *selected_tetrahedra(session);
    const MotionFrame stands = frame(volume);
    kind_ = kind;
    axes_ = stands.axes;
    to_volume_ = glm::inverse(glm::dmat3(volume.tetrahedra_to_world));
    alone_ = pull_of(places_, chosen_);
    alone_.layer = layer_;
    alone_.radius = rounded(alone_.radius, 3);
    pull_ = alone_;
    gesture_.begin(kind, object_, stands, handle, session.view.camera, input);
}

Command TetrahedraPoints::wanted()
{
    const Motion motion = gesture_->motion();
    TetrahedraPull out = alone_;
    out.guard = manner_.guard;
    if (manner_.proportional) {
        out.radius = manner_.radius;
        out.decay = manner_.decay;
    }
    if (motion.kind == MotionKind::move) out.by = tidied(to_volume_ * (axes_ * motion.offset));
    if (motion.kind == MotionKind::scale) out.factors = motion.factors;
    if (motion.kind == MotionKind::rotate) {
        const glm::dvec3 axis = tidied(glm::normalize(motion.turn_axis));
        for (int a = 0; a < 3; ++a) // about one of them it may be more than a whole turn
            if (std::abs(axis[a]) == 1) out.rotation_deg[a] = axis[a] * motion.angle_deg;
        if (out.rotation_deg == glm::dvec3(0))
            out.rotation_deg =
                decomposed(glm::rotate(glm::dmat4(1), glm::radians(motion.angle_deg), axis))
                    .rotation_deg;
    }
    pull_ = out;
    return EditTetrahedra{object_, {.pull = pull_}};
}

void TetrahedraPoints::go_on(Session& session, const ViewportInput& input)
{
    const Gesture::State state = gesture_.go_on(session, input, [&] { return wanted(); });
    const bool clicked = state == Gesture::State::dropped && !gesture_.meant() && pressed_;
    if (clicked && *pressed_ < static_cast<int>(places_.size())) chosen_ = {*pressed_};
}

void TetrahedraPoints::cancel(Session& session)
{
    box_px_.reset();
    gesture_.cancel(session);
}

void TetrahedraPoints::take_keys(Session& session)
{
    if (gesture_ && gesture_.take_keys()) gesture_.finish(session, [&] { return wanted(); });
}

std::string TetrahedraPoints::words() const
{
    return fmt::format("{} of {}", chosen_.size(), places_.size());
}

} // namespace trivar
