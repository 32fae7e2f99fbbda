// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/placement_handles.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/placement/place.h"
#include "core/commands/words/changes.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/placement/redraw.h"
#include "core/steps/laying/attaching.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/strip_paint.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

using ProfilePoints = std::vector<glm::dvec2>;

constexpr double px_a_place = 130; // of the stroke, as it was drawn
constexpr int least_places = 3, most_places = 9;
constexpr double least_ratio = 0.05, most_ratio = 20; // of sizes, in one drag
constexpr double shortest_fill = 0.02;
constexpr double end_on_px = 14;    // a size that looks shorter is on a stalk ...
constexpr double stalk_px = 44;     // ... of this length
constexpr double narrowest_px = 11; // a rim, from the middle
constexpr double beyond_px = 16;    // start and end, from the ends
constexpr double further_in = 0.02; // along the stroke
constexpr double across_at_u = 0.6; // where the points of the height across stand

// A TakenPlacement is the object as it lay when a hand took one of its handles.
struct TakenPlacement {
    Id object = 0;
    PlacementStep step; // its stroke is what it is now, in a space that to_world takes to the world
    Ref<Placement> placement;
    Ref<RayScene> scene; // on which the stroke falls
    glm::dmat4 to_world{1};
    std::optional<Attachment> hosts = {}; // as they stand there
    double scale() const { return glm::length(glm::dvec3(to_world[0])); }
};

// A PlacementPull is a hand on a taken object. `times`: the way from the base is so much longer.
struct PlacementPull {
    const TakenPlacement& before;
    const HandMove& move;
    double times = 1;
};
using PlacementChange = std::function<void(EditPlacement& edit, const PlacementPull& pull)>;

// A VolumeSpot is the place of a handle, and the base that its distance is measured from: the roof
// for contact and floor, a place further in for start and end.
struct VolumeSpot {
    glm::dvec3 p_world{0}, base_world{0};
    int stalk = 0;       // it is on a stalk where it is seen end-on: up it grows, 1, or shrinks, -1
    double least_px = 0; // so far from the base it is drawn at least ...
    double off_px = 0;   // ... and so much further off
    double present = 0;  // metres in the world: the size that a typed one replaces; 0: it is none
    glm::dvec2 way_px(const Camera& camera) const
    {
        return project(camera, p_world).p_px - project(camera, base_world).p_px;
    }
    bool end_on(const Camera& camera, double scale) const
    {
        return stalk != 0 && glm::length(way_px(camera)) < end_on_px * scale;
    }
    glm::dvec2 seen_at(const Camera& camera, double scale) const
    {
        const glm::dvec2 p_px = project(camera, p_world).p_px, way = way_px(camera);
        if (end_on(camera, scale)) return p_px - glm::dvec2(0, stalk_px * scale);
        const double length = glm::length(way);
        if (!(length > 0)) return p_px;
        return p_px + way * ((std::max(0.0, least_px * scale - length) + off_px * scale) / length);
    }
};

ProfilePoints or_middle(const ProfilePoints& profile)
{
    return profile.empty() ? ProfilePoints{{0.5, 1}} : profile;
}

// Four digits, as drags of numbers give; in round steps a tenth of the size. Typed ones stay.
double handy(double value, const HandMove& move)
{
    return move.typed ? value : rounded(value, move.snap ? 2 : 4);
}

double growth(const VolumeSpot& spot, const HandMove& move)
{
    if (move.typed && spot.present > 0) return *move.typed / spot.present;
    const glm::dvec2 by_px = move.by_px(), way = spot.way_px(move.camera);
    if (spot.end_on(move.camera, move.scale)) { // a pixel upward is a pixel's length
        const double size = glm::distance(spot.p_world, spot.base_world);
        const double depth = project(move.camera, spot.base_world).depth_world;
        const double up = -by_px.y * pixel_size_world(move.camera, depth);
        return std::clamp(1 + spot.stalk * up / size, least_ratio, most_ratio);
    }
    const double square = glm::dot(way, way);
    if (!(square > 1)) return 1;
    return std::clamp(glm::dot(way + by_px, way) / square, least_ratio, most_ratio);
}

// A point of a profile so that the curve there is as high as asked for.
void raise(ProfilePoints& profile, std::size_t point, double wanted, const HandMove& move)
{
    const double u = profile[point].x, before = ShareCurve(profile).at(u);
    ProfilePoints higher = profile;
    higher[point].y += 1;
    // The weight of the point's height on the curve
    const double weight = ShareCurve(higher).at(u) - before;
    profile[point].y = handy(profile[point].y + (wanted - before) / std::max(0.1, weight), move);
}

// A size without a profile grows as a whole, else the profile does at its point. `present`: as it
// is laid, metres in the world.
void grow(double& size, ProfilePoints& profile, double present, std::size_t point,
          const PlacementPull& pull)
{
    if (profile.empty()) {
        size = handy(present / pull.before.scale() * pull.times, pull.move);
        return;
    }
    raise(profile, point, Profile(profile).at(profile[point].x) * pull.times, pull.move);
    profile[point].y = std::clamp(profile[point].y, least_profile, most_profile);
}

// The value of a height map so that the surface there is so many times as high.
void raise(HeightGrid& grid, int i, int j, const PlacementPull& pull)
{
    const HeightMap map(grid);
    const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
    const double before = map.at(map.along()[I], map.across()[J]);
    const double by = before * (pull.times - 1) / std::max(0.1, map.weight(i, j));
    grid[I][J] = std::clamp(handy(grid[I][J] + by, pull.move), least_profile, most_profile);
}

Sketch pulled(const TakenPlacement& before, const glm::dvec3& held_world, const HandMove& move)
{
    const Camera& drawn = before.step.sketch.camera;
    const glm::dmat4 from_world = glm::inverse(before.to_world);
    const Camera camera = carried(move.camera, from_world);
    const glm::dvec3 held(from_world * glm::dvec4(held_world, 1));
    const glm::dvec2 own = project(drawn, held).p_px;
    const std::vector<StrokeSample> seen =
        seen_from(drawn, camera, {{move.from_px, 0, 1}, {move.to_px, 0, 1}}, *before.scene);
    const glm::dvec2 by =
        seen.size() == 2
            ? seen[1].p_px - seen[0].p_px
            : project(drawn, held + dragged_across(camera, held, move.from_px, move.to_px)).p_px -
                  own;
    const double share = nearest_share(before.step.sketch, own).share;
    const double reach =
        std::clamp(px_a_place / length_px(before.step.sketch.samples), 1.0 / most_places, 0.5);
    return bent(before.step.sketch, share, by, reach);
}

// The place along the stroke to which the hand has taken a point of its line.
double line_at(const PlacementPull& pull, const glm::dvec3& held_world)
{
    if (pull.move.typed) return *pull.move.typed / 100;
    const Camera& camera = pull.move.camera;
    const glm::dvec2 shown = project(camera, held_world).p_px;
    const double u = nearest_on_line(*pull.before.placement, camera, shown + pull.move.by_px()).u;
    return pull.move.snap ? std::round(u * 20) / 20 : std::round(u * 1000) / 1000;
}

HandleDrag drag_of_placement(const Session& session, const VolumeSpot& spot,
                             const PlacementChange& change)
{
    const EvaluatedObject* laid = selected_placement(session);
    if (!laid) return {};
    TakenPlacement before{laid->id, *object(session.document(), laid->id).stroke,
                          laid->stroke_placement(), laid->lies_on, stroke_to_world(*laid)};
    before.hosts = hosts_now(*laid, before.step);
    before.step.sketch = stroke_now(*laid, before.step);
    return {[before, spot, change](const HandMove& move) {
                EditPlacement edit{before.object, before.step.parameters, {}, {}};
                change(edit, {before, move, growth(spot, move)});
                return edit;
            },
            [id = before.object](Session& s) { s.commit_if_placed(id); }};
}

struct HandlesOfPlacement {
    const Session& session;
    const EvaluatedObject& laid;
    double scale = 1; // of the interface
    std::vector<Handle> out = {};
    const Camera& camera = session.view.camera;
    const PlacementStep& step = *object(session.document(), laid.id).stroke;
    const PlacementParameters& now = step.parameters;
    const Placement& placement = *laid.stroke_placement();
    double floor = placement.ground;   // w of the level that lies on the scene
    double roof = floor > 0.5 ? 0 : 1; // of the face that is further from it

    VolumeSpot spot(const glm::dvec3& uvw, const glm::dvec3& base) const
    {
        return {evaluate(placement.volume, uvw).value, evaluate(placement.volume, base).value};
    }

    void add(Handle handle, const VolumeSpot& spot, const PlacementChange& change)
    {
        const PicturePoint at = project(camera, spot.p_world);
        if (at.depth_world <= 0) return;
        handle.p_world = spot.p_world;
        handle.p_px = spot.seen_at(camera, scale);
        handle.base_px = project(camera, spot.base_world).p_px;
        handle.way_px = handle.p_px - handle.base_px;
        if (handle.look != Handle::Look::arrow && glm::distance(handle.p_px, at.p_px) > 1)
            handle.thread = Handle::Thread::always; // it would look lost
        handle.take = [&current = session, spot, change] {
            return drag_of_placement(current, spot, change);
        };
        out.push_back(std::move(handle));
    }

    // A size in metres, which is so large at a place of the volume.
    void add_size(const HandleKey& key, VolumeSpot spot, double present,
                  const PlacementChange& change)
    {
        const bool across = key.kind == "width";
        spot.present = present;
        add({.key = key,
             .thread = Handle::Thread::lit,
             .color = across ? &ui::Palette::free_node : &ui::Palette::lattice,
             .words = (across ? "width " : "height ") + in_metres(present),
             .number = Handle::Number::length,
             .verb = across ? "Drag to widen" : "Drag to raise"},
            spot, change);
    }

    void add_widths()
    {
        const Profile widths(now.width_profile);
        const ProfilePoints points = or_middle(now.width_profile);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (const int side : {0, 1}) {
                const double u = points[i].x;
                VolumeSpot at = spot({u, side, floor}, {u, 0.5, floor});
                at.least_px = narrowest_px; // a narrow strip's rims keep apart
                add_size({"width", {2 * static_cast<int>(i) + side}}, at,
                         placement.report.width_world * widths.at(u),
                         [i](EditPlacement& edit, const PlacementPull& pull) {
                             grow(edit.parameters.width, edit.parameters.width_profile,
                                  pull.before.placement->report.width_world, i, pull);
                         });
            }
    }

    void add_heights()
    {
        const Profile along(now.height_profile), across(now.height_across);
        const HeightMap map(now.height_map);
        const auto add_height = [&](const HandleKey& key, double u, double v, double factor,
                                    const PlacementChange& change) {
            VolumeSpot at = spot({u, v, roof}, {u, v, floor});
            at.stalk = key.kind == "across" ? 0 : 1;
            add_size(key, at, placement.report.height_world * factor, change);
        };
        const auto grown = [](ProfilePoints PlacementParameters::*profile,
                              std::size_t i) -> PlacementChange {
            return [=](EditPlacement& edit, const PlacementPull& pull) {
                grow(edit.parameters.height, edit.parameters.*profile,
                     pull.before.placement->report.height_world, i, pull);
            };
        };
        const ProfilePoints points = or_middle(now.height_profile);
        const bool shown = now.height_map.empty() || !now.height_profile.empty(); // else map's are
        for (std::size_t i = 0; i < points.size() && shown; ++i)
            add_height({"height", {static_cast<int>(i)}}, points[i].x, 0.5, along.at(points[i].x),
                       grown(&PlacementParameters::height_profile, i));
        for (std::size_t i = 0; i < now.height_across.size(); ++i) {
            const double v = now.height_across[i].x;
            add_height({"across", {static_cast<int>(i)}}, across_at_u, v, across.at(v),
                       grown(&PlacementParameters::height_across, i));
        }
        for (int i = 0; const double u : map.along()) {
            for (int j = 0; const double v : map.across()) {
                add_height({"map", {i, j}}, u, v, along.at(u) * across.at(v) * map.at(u, v),
                           [i, j](EditPlacement& edit, const PlacementPull& pull) {
                               raise(edit.parameters.height_map, i, j, pull);
                           });
                ++j;
            }
            ++i;
        }
    }

    void add_rise()
    {
        const ProfilePoints& rise = now.rise_profile;
        for (std::size_t i = 1; i + 1 < rise.size(); ++i) {
            const double at = rise[i].x;
            const VolumeSpot up = spot({2.0 / 3, 0, at}, {2.0 / 3, 0, 0});
            if (glm::length(up.way_px(camera)) < end_on_px * scale) continue; // all on one spot
            add({.key = {"rise", {static_cast<int>(i)}},
                 .thread = Handle::Thread::lit,
                 .color = &ui::Palette::contact,
                 .words = fmt::format("{} of the model in {} of the height", percent_text(at),
                                      percent_text(ShareCurve(rise).at(at))),
                 .verb = "Drag to change the height distribution"},
                up, [i](EditPlacement& edit, const PlacementPull& pull) {
                    ProfilePoints& points = edit.parameters.rise_profile;
                    raise(points, i, ShareCurve(points).at(points[i].x) * pull.times, pull.move);
                    const double below = points[i - 1].y, above = points[i + 1].y;
                    points[i].y = std::clamp(points[i].y, below + least_rise,
                                             std::max(below, above - 2 * least_rise) + least_rise);
                });
        }
    }

    // The level that lies on the scene, and the floor under it.
    void add_levels()
    {
        VolumeSpot at = spot({1.0 / 3, 1, floor}, {1.0 / 3, 1, roof});
        at.stalk = -1;
        const double deep_world = glm::distance(at.p_world, at.base_world);
        if (!step.round)
            add({.key = {"contact"},
                 .color = &ui::Palette::contact,
                 .words = "clearance " + in_metres(now.clearance),
                 .number = Handle::Number::length,
                 .verb = "Drag to lift off the surface"},
                at, [deep_world](EditPlacement& edit, const PlacementPull& pull) {
                    PlacementParameters& p = edit.parameters;
                    const double into = p.contact_level > 0.5 ? -1 : 1; // away from the roof
                    const double by = into * deep_world / pull.before.scale() * (1 - pull.times);
                    p.clearance =
                        std::max(0.0, handy(pull.move.typed.value_or(p.clearance + by), pull.move));
                });
        if (placement.contact.axes[0].closure() == Closure::twisted) return;
        at = spot({2.0 / 3, 1, 0}, {2.0 / 3, 1, 1});
        at.stalk = -1;
        add({.key = {"sunk"},
             .look = Handle::Look::ring, // the level, not the distance
             .color = &ui::Palette::contact,
             .words = "sunk " + percent_text(now.contact_level),
             .number = Handle::Number::percent,
             .verb = "Drag down to sink it in"},
            at, [](EditPlacement& edit, const PlacementPull& pull) {
                // The floor away from the roof: so much of the height lies deeper.
                PlacementParameters& p = edit.parameters;
                const Rise rise(p.rise_profile, pull.before.placement->volume.displacement.axes[2]);
                const double risen = rise.at(p.contact_level) + pull.times - 1;
                const double level = rise.w_at(std::clamp(risen, 0.0, 1.0));
                p.contact_level =
                    handy(pull.move.typed ? *pull.move.typed / 100 : level, pull.move);
            });
    }

    void add_places()
    {
        const int places = std::clamp(
            1 + static_cast<int>(std::lround(length_px(step.sketch.samples) / px_a_place)),
            least_places, most_places);
        for (int i = 0; i < places && !step.round; ++i) {
            const double u = static_cast<double>(i) / (places - 1);
            const VolumeSpot at = spot({u, 0.5, floor}, {u, 0.5, floor});
            add({.key = {"stroke", {i}},
                 .words = "length " + in_metres(placement.report.length_world),
                 .verb = "Drag to bend the stroke"},
                at, [p_world = at.p_world](EditPlacement& edit, const PlacementPull& pull) {
                    edit.sketch = pulled(pull.before, p_world, pull.move);
                    edit.attach = pull.before.hosts;
                });
        }
    }

    void add_ends()
    {
        const double end = now.start + now.fill;
        const auto add_end = [&](const char* kind, double u, double inner, const char* verb,
                                 const std::function<void(PlacementParameters&, double)>& set) {
            VolumeSpot at = spot({u, 0.5, floor}, {inner, 0.5, floor});
            at.off_px = beyond_px;
            add({.key = {kind},
                 .look = Handle::Look::arrow,
                 .words = fmt::format("{} {}", kind, percent_text(u)),
                 .number = Handle::Number::percent,
                 .verb = verb},
                at, [set, p_world = at.p_world](EditPlacement& edit, const PlacementPull& pull) {
                    set(edit.parameters, line_at(pull, p_world));
                });
        };
        add_end("start", now.start, now.start + further_in, "Drag to move the start",
                [](PlacementParameters& p, double u) {
                    const double last = p.start + p.fill;
                    p.start = std::clamp(u, 0.0, std::max(0.0, last - shortest_fill));
                    p.fill = last - p.start;
                });
        add_end("end", end, end - further_in, "Drag to move the end",
                [](PlacementParameters& p, double u) {
                    p.fill = std::clamp(u, std::min(1.0, p.start + shortest_fill), 1.0) - p.start;
                });
    }
};

} // namespace

std::vector<Handle> placement_handles(const Session& session, HandleChoice choice, double scale)
{
    const EvaluatedObject* laid = selected_placement(session);
    if (!laid || choice == HandleChoice::none) return {};
    HandlesOfPlacement handles{session, *laid, scale};
    handles.add_widths();
    handles.add_heights();
    handles.add_rise();
    handles.add_levels();
    handles.add_places();
    handles.add_ends();
    std::erase_if(handles.out, [&](const Handle& each) {
        const std::string_view kind = each.key.kind;
        const bool of_stroke = kind == "stroke" || kind == "start" || kind == "end";
        return choice != HandleChoice::all && (choice == HandleChoice::stroke) != of_stroke;
    });
    return std::move(handles.out);
}

float end_of_words(const ui::Theme& theme, const ViewportInput& input)
{
    return strip_legend_at(theme, input.rect).x;
}

std::optional<ui::Option> handles_option(const Session& session, const ui::Theme& theme,
                                         HandleChoice& choice)
{
    if (!selected_placement(session)) return std::nullopt;
    return ui::Option{
        "Handles", 224,
        [&choice, &theme](float width) {
            int chosen = static_cast<int>(choice);
            ui::segments(theme, "handles", chosen, {"All", "Stroke", "Sizes", "None"}, width);
            choice = static_cast<HandleChoice>(chosen);
        },
        "Which points of the selected stroke can be dragged in the viewport."};
}

} // namespace trivar
