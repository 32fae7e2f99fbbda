// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/split_handles.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/split.h"
#include "core/split/split_field.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/motion.h"
#include "editor/session/session.h"
#include "editor/tools/split/shown_cut.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double outward_px = 17;      // how much further out the arrows stand
constexpr double seen_end_on = 0.2;    // sine of the angle below which a way is not followed
constexpr double least_in_room = 0.02; // share of the room that a handle stays from its ends

Box box_in_frame(const SplitFrame& frame, const Box& world)
{
    Box out;
    for (const glm::dvec3& corner : world.corners()) out.add(frame.uvw(corner));
    return out;
}

// The middle of what both ranges have in common, or of the first one.
double common_middle(double lo, double hi, double other_lo, double other_hi)
{
    const double from = std::max(lo, other_lo), to = std::min(hi, other_hi);
    if (from < to) return (from + to) / 2;
    const double inset = least_in_room * (hi - lo);
    return std::clamp(other_lo, lo + inset, hi - inset);
}

// Four digits, as drags of numbers give; in round steps two. A typed number stays as it is.
double handy_metres(double value, const HandMove& move)
{
    return move.typed ? *move.typed : rounded(std::max(0.0, value), move.snap ? 2 : 4);
}

// The selected object, if it is the only one, visible and not locked, and has bounds; else null.
const EvaluatedObject* handled(const Session& session)
{
    if (session.selected.size() != 1 || locked(session.document(), session.selected))
        return nullptr;
    const auto shown = session.evaluated().objects.find(session.selected);
    if (shown == session.evaluated().objects.end() || shown->second->bounds->empty() ||
        !session.document().objects.contains(session.selected))
        return nullptr;
    return shown->second.get();
}

// The object itself; null: there is none.
const Object* own_of(const Session& session)
{
    const EvaluatedObject* shown = handled(session);
    return shown ? &object(session.document(), shown->id) : nullptr;
}

// Makes the handles of an object, each with the command for a hand that has come so many metres
// along its way.
struct SplitHandles {
    const Session& session;
    const EvaluatedObject& shown;
    double scale = 1; // of the interface
    std::vector<Handle> out = {};

    // Adds a handle that goes along a unit way, unless it is behind the eye or its way points at
    // it. Arrows stand a little further out, tied to a base.
    void add(Handle handle, const glm::dvec3& p_world, const glm::dvec3& base_world,
             const glm::dvec3& way)
    {
        const Camera& camera = session.view.camera;
        const PicturePoint at = project(camera, p_world);
        if (!(at.depth_world > 0)) return;
        // The way as it is seen, per metre, against a way across the picture
        const double pixel = pixel_size_world(camera, at.depth_world);
        const glm::dvec2 seen = project(camera, p_world + way * pixel).p_px - at.p_px;
        if (!(glm::length(seen) > seen_end_on) && handle.key.kind != "place") return;
        handle.p_world = p_world;
        handle.p_px = at.p_px;
        handle.base_px = project(camera, base_world).p_px;
        if (handle.look == Handle::Look::arrow) {
            handle.p_px += glm::normalize(seen) * outward_px * scale;
            handle.way_px = handle.p_px - handle.base_px;
            handle.thread = Handle::Thread::always;
            handle.color = &ui::Palette::free_node;
        }
        out.push_back(std::move(handle));
    }
    // Adds a handle of a number of the obstacles of an opening, which grows with its way.
    void add_number(Handle handle, const glm::dvec3& p_world, const glm::dvec3& base_world,
                    const glm::dvec3& way, const std::vector<Id>& obstacles, double value,
                    const std::function<void(ObstacleUse&, double)>& set)
    {
        handle.number = Handle::Number::length;
        handle.take = [=, &now = session, id = shown.id] {
            const Object* own = own_of(now);
            if (!own || !own->splitting) return HandleDrag{}; // it was only proposed
            return HandleDrag{[=, before = *own->splitting](const HandMove& move) {
                Split edit{{id}, before};
                const double by =
                    dragged_along(move.camera, p_world, way, move.from_px, move.to_px);
                for (ObstacleUse& use : edit.splitting.obstacles)
                    if (std::ranges::find(obstacles, use.object) != obstacles.end())
                        set(use, handy_metres(value + by, move));
                return edit;
            }};
        };
        add(std::move(handle), p_world, base_world, way);
    }
    // Adds a handle that changes a cut.
    void add_to_cut(Handle handle, const glm::dvec3& p_world, const glm::dvec3& base_world,
                    const glm::dvec3& way,
                    const std::function<void(PlainCut&, const HandMove&, double by)>& set)
    {
        handle.take = [=, &now = session, id = shown.id,
                       number = static_cast<std::size_t>(handle.key.numbers[0])] {
            const Object* own = own_of(now);
            if (!own || !own->cutting || number >= own->cutting->cuts.size()) return HandleDrag{};
            return HandleDrag{[=, before = *own->cutting](const HandMove& move) {
                CutThrough edit{{id}, before};
                set(edit.cutting.cuts[number], move,
                    dragged_along(move.camera, p_world, way, move.from_px, move.to_px));
                return edit;
            }};
        };
        add(std::move(handle), p_world, base_world, way);
    }
};

// Moves the obstacles of an opening in a plane through it.
HandleDrag obstacle_drag(const std::vector<Stand>& obstacles, const glm::dvec3& p_world,
                         const glm::dvec3& normal)
{
    return {[=](const HandMove& move) {
        glm::dvec3 by = dragged_in_plane(move.camera, p_world, normal, move.from_px, move.to_px);
        if (move.snap) by = glm::round(by * 10.0) / 10.0;
        std::vector<Id> ids;
        std::vector<Transform> transforms;
        for (const Stand& stand : obstacles) {
            ids.push_back(stand.id);
            transforms.push_back(moved(stand, {.offset = by}, {stand.origin_world()}));
        }
        return arranged(ids, transforms);
    }};
}

} // namespace

std::vector<Handle> opening_handles(const Session& session, double scale)
{
    const EvaluatedObject* shown = handled(session);
    if (!shown || !shown->split_field) return {};
    const std::optional<Splitting>& splitting = object(session.document(), shown->id).splitting;
    if (!splitting) return {};
    SplitHandles handles{session, *shown, scale};
    const SplitField& field = *shown->split_field;
    const Box there = box_in_frame(field.frame, *shown->bounds);
    const glm::dmat3& axes = field.frame.axes;
    for (int number = 0; const Opening& opening : field.openings) {
        const glm::dvec2 lo = opening.walls[0].lo(), hi = opening.walls[0].hi();
        const glm::dvec2 vw((lo.x + hi.x) / 2, common_middle(lo.y, hi.y, there.lo.z, there.hi.z));
        const double phi = opening.surface_cells.value(vw);
        const auto at = [&](double beyond) { return field.frame.world({phi + beyond, vw}); };
        const std::vector<Id> ids(opening.objects.begin(), opening.objects.end());
        const glm::dvec3 base = at(0);
        const auto drag = [=, &session, up = axes[2]] {
            return obstacle_drag(stands_of(session.document(), ids), base, up);
        };
        if (!stands_of(session.document(), ids).empty())
            handles.add({.key = {"place", {number}},
                         .words = "Obstacle",
                         .verb = "Drag to move the obstacle",
                         .take = drag},
                        base, base, axes[1]);
        double clearance = 0;
        for (const ObstacleUse& use : splitting->obstacles)
            if (std::ranges::find(ids, use.object) != ids.end())
                clearance = std::max(clearance, use.clearance);
        for (const int side : {-1, 1}) {
            const std::size_t s = side > 0 ? 1 : 0;
            const glm::dvec3 way = static_cast<double>(side) * axes[0];
            handles.add_number({.key = {"clearance", {number, side}},
                                .color = &ui::Palette::lattice,
                                .words = fmt::format("Clearance {} m", number_text(clearance)),
                                .verb = "Drag to leave more room round the obstacle"},
                               at(side * opening.wall_cells[s].value(vw)), base, way, ids,
                               clearance,
                               [](ObstacleUse& use, double metres) { use.clearance = metres; });
            const double reach = opening.reach[s], least = needed_reach(opening, s, opening.kernel);
            handles.add_number({.key = {"reach", {number, side}},
                                .look = Handle::Look::arrow,
                                .words = fmt::format("Reach {} m{}", number_text(reach),
                                                     reach > least * 1.0001 ? "" : ", the least"),
                                .verb = "Drag to let the opening reach further"},
                               at(side * reach), base, way, ids, reach,
                               [least](ObstacleUse& use, double metres) {
                                   use.reach = metres > least ? metres : 0; // 0: as far as it needs
                               });
        }
        ++number;
    }
    return std::move(handles.out);
}

std::vector<Handle> cut_handles(const Session& session, double scale)
{
    const EvaluatedObject* shown = handled(session);
    if (!shown) return {};
    const std::optional<Cutting>& cutting = object(session.document(), shown->id).cutting;
    if (!cutting) return {};
    SplitHandles handles{session, *shown, scale};
    const glm::dmat3 to_world(shown->own_to_world),
        normals = glm::transpose(glm::inverse(to_world));
    for (std::size_t i = 0; i < cutting->cuts.size(); ++i) {
        const PlainCut& cut = cutting->cuts[i];
        if (!cut.cuts()) continue;
        const ShownCut seen = shown_cut(*cutting, i, *shown);
        const glm::dvec3 up = glm::normalize(normals * glm::normalize(cut.normal));
        const auto number = static_cast<int>(i);
        handles.add_to_cut({.key = {"level", {number}},
                            .words = "Place of the cut",
                            .verb = "Drag to move the cut"},
                           seen.middle, seen.middle, up,
                           [=](PlainCut& to, const HandMove& move, double by) {
                               const double step = move.snap ? std::round(by * 10) / 10 : by;
                               // Along its normal alone: the plane stays parallel whatever the
                               // object's scale
                               const glm::dvec3 way = glm::inverse(to_world) * (up * step);
                               const glm::dvec3 n = glm::normalize(to.normal);
                               to.point += n * glm::dot(n, way);
                               for (int k = 0; k < 3; ++k) to.point[k] = rounded(to.point[k], 9);
                           });
        if (cut.keep != CutKeep::both) continue;
        for (const int side : {-1, 1})
            handles.add_to_cut({.key = {"gap", {number, side}},
                                .look = Handle::Look::arrow,
                                .words = fmt::format("Gap {} m", number_text(cut.gap)),
                                .number = Handle::Number::length,
                                .verb = "Drag to move both parts apart"},
                               seen.faces[side > 0 ? 1 : 0], seen.middle,
                               static_cast<double>(side) * up,
                               [gap = cut.gap](PlainCut& to, const HandMove& move, double by) {
                                   to.gap = handy_metres(gap + 2 * by, move);
                               });
    }
    return std::move(handles.out);
}

} // namespace trivar
