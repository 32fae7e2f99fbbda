// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedra_points.h"

#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"
#include "core/commands/volumes/tetrahedra.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/session/session.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

constexpr std::size_t most_points = 400000;

// Returns the places that can be moved: of a refinement not the ones at its rim.
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

double PullBall::radius_in(const Session& session, double share) const
{
    if (radius > 0) return radius;
    const TetrahedraShape* shape = session.selected.size() == 1
                                       ? tetrahedra_shape(session.document(), session.selected)
                                       : nullptr;
    if (!shape) return 0.25;
    const glm::dvec3 size = size_of(*shape);
    return rounded(share * std::cbrt(size.x * size.y * size.z), 2);
}

void TetrahedraPoints::look(const Session& session)
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    const TetrahedraShape* shape =
        volume ? tetrahedra_shape(session.document(), volume->id) : nullptr;
    if (!volume || !shape) {
        object_ = layer_ = 0;
        basis_ = nullptr;
        chosen_.clear();
        at_world_.clear();
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

const EvaluatedObject* TetrahedraPoints::seen(const Session& session) const
{
    return selected_tetrahedra(session);
}

Id TetrahedraPoints::cage_of(const Session& session, Id under) const
{
    return tetrahedra_holding(session, under);
}

MotionFrame TetrahedraPoints::frame(const Session& session) const
{
    glm::dvec3 middle(0);
    for (const int i : chosen_) middle += at_world_[static_cast<std::size_t>(i)];
    return {middle / static_cast<double>(chosen_.size()), axes_of(*selected_tetrahedra(session))};
}

// Returns the chosen points and those that share a cell with one.
std::vector<int> TetrahedraPoints::chosen_and_next() const
{
    std::set<int> cells;
    for (const int i : chosen_) {
        const std::vector<int>& of = places_[static_cast<std::size_t>(i)].cells;
        cells.insert(of.begin(), of.end());
    }
    std::vector<int> out;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (std::ranges::find(chosen_, static_cast<int>(i)) != chosen_.end() ||
            std::ranges::any_of(places_[i].cells, [&](int cell) { return cells.contains(cell); }))
            out.push_back(static_cast<int>(i));
    return out;
}

double TetrahedraPoints::radius(const Session& session) const
{
    return ball_.radius_in(session, 0.35);
}

bool TetrahedraPoints::resize(Session& session, double factor)
{
    if (proportional_) ball_.radius = rounded(radius(session) * factor, 3);
    return proportional_;
}

std::optional<std::vector<std::string>> TetrahedraPoints::numbers(const Session& session) const
{
    if (chosen_.empty() || object_ != session.selected) return {};
    TetrahedraPull chosen = pull_of(places_, chosen_);
    chosen.layer = layer_;
    const TetrahedraShape* shape = tetrahedra_shape(session.document(), object_);
    for (std::size_t i = shape ? shape->edits.size() : 0; i-- > 0;)
        if (shape->edits[i].pull && are_alike(*shape->edits[i].pull, chosen))
            return numbers_below(fmt::format("shape.edits.{}.pull", i));
    return std::vector<std::string>();
}

void TetrahedraPoints::begin_motion(const Session& session)
{
    const EvaluatedObject& volume = *selected_tetrahedra(session);
    axes_ = axes_of(volume);
    to_volume_ = glm::inverse(glm::dmat3(volume.tetrahedra_to_world));
    alone_ = pull_of(places_, chosen_);
    alone_.layer = layer_;
    alone_.radius = rounded(alone_.radius, 3);
    pull_ = alone_;
}

Command TetrahedraPoints::wanted(const Session& session)
{
    const Motion motion = gesture_->motion();
    pull_ = alone_;
    pull_.guard = ball_.guard;
    if (proportional_) {
        pull_.radius = radius(session);
        pull_.decay = ball_.decay;
    }
    if (motion.kind == MotionKind::move)
        pull_.by = without_rounding(to_volume_ * (axes_ * motion.offset));
    if (motion.kind == MotionKind::scale) pull_.factors = motion.factors;
    if (motion.kind == MotionKind::rotate) pull_.rotation_deg = turn_of(motion, motion.turn_axis);
    return EditTetrahedra{object_, {.pull = pull_}};
}

std::string TetrahedraPoints::words() const
{
    return fmt::format("{} of {}", chosen_.size(), places_.size());
}

} // namespace trivar
