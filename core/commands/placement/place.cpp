// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/place.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/travel.h"
#include "core/commands/words/changes.h"
#include "core/commands/words/field_words.h"
#include "core/commands/words/stroke_title.h"
#include "core/document/band.h"
#include "core/document/check_view.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/placement/round.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Throws Rejected for a group, which has no shape to place; a lattice has its box.
void check_can_be_laid(const Document& document, Id id)
{
    if (!kind_of(document, id).has_shape)
        throw Rejected(named(document, id) + " is a group; place the objects in it");
    if (object(document, id).tiles)
        throw Rejected(named(document, id) +
                       " is a layer of tiles; make it a single object first, or place a copy");
}

// Removes the edits of the volume of a stroke, with the stroke; a lattice keeps the edits of its
// box.
void forget_shaping(Object& o)
{
    if (!kind_of(o).has_cage) o.shaping.clear();
}

// Largest number of supports, more than any stroke meets; each placement stores its whole list.
constexpr std::size_t most_supports = 4096;

void check_count(const std::vector<Id>& supports)
{
    if (supports.size() > most_supports)
        throw Rejected(fmt::format("field \"onto\" comes to {} objects but at most {} are allowed; "
                                   "name those that the stroke meets",
                                   supports.size(), most_supports));
}

bool stands_in(const Document& document, Id id, Id lattice)
{
    const std::vector<Id> round = lattices_round(document, id);
    return std::ranges::find(round, lattice) != round.end();
}

// Lists the objects that a stroke may fall on: the named ones with the contents of groups, or all
// visible ones; empty only if it falls on the ground.
std::vector<Id> supports(const Document& document, Id id, const std::vector<Id>& onto,
                         bool on_ground = false)
{
    const std::set<Id> above = depending_on(document, {id});
    std::vector<Id> result;
    if (onto.empty()) {
        result = possible_bases(document, id);
        if (result.empty() && !on_ground)
            throw Rejected(fmt::format("there is nothing visible that {} could lie on; add or "
                                       "show another object first, or draw on the ground",
                                       named(document, id)));
        check_count(result);
        return result;
    }
    std::set<Id> given(onto.begin(), onto.end());
    for (const Id other : given) object(document, other);
    for (const Id other : with_contents(document, std::move(given))) {
        if (!kind_of(document, other).has_surface) continue;
        if (other == id) throw Rejected("field \"onto\": an object cannot lie on itself");
        if (above.contains(other))
            throw Rejected(fmt::format(
                "field \"onto\": {} {} {} already, so the other way round is "
                "impossible",
                named(document, other), stands_in(document, other, id) ? "is in" : "lies on",
                named(document, id)));
        result.push_back(other);
    }
    if (result.empty()) throw Rejected("field \"onto\" names only empty groups");
    check_count(result);
    return result;
}

void check_sketch(const Sketch& sketch)
{
    check_view(sketch.camera);
    if (sketch.samples.size() < 2)
        throw Rejected("field \"samples\" has fewer than two points; press, draw a line over the "
                       "scene, and let go");
}

void check_parameters(const PlacementParameters& p)
{
    if (static_cast<double>(p.grid.x) * p.grid.y * p.grid.z > most_control_points)
        throw Rejected(fmt::format("field \"grid\" makes more than {} control points",
                                   static_cast<int>(most_control_points)));
    for (int i = 0; i < 3; ++i)
        if (p.grid[i] < p.orders[i])
            throw Rejected(fmt::format("field \"grid\": order {} needs at least {} control points "
                                       "along the axis, not {}",
                                       p.orders[i], p.orders[i], p.grid[i]));
    if (p.start + p.fill > 1 + 1e-12)
        throw Rejected("fields \"start\" and \"fill\" add up to more than 1, the whole stroke");
    check_profile(p.width_profile, "field \"width_profile\"");
    check_profile(p.height_profile, "field \"height_profile\"");
    check_profile(p.height_across, "field \"height_across\"");
    check_height_map(p.height_map, "field \"height_map\"");
    check_rise(p.rise_profile, "field \"rise_profile\"");
    if (p.roll_deg != 90 * std::floor(p.roll_deg / 90))
        throw Rejected("field \"roll_deg\" must be 0, 90, 180 or 270");
}

// Throws Rejected if there is no plane, or the object has no surface to cut.
void check_cut(const Document& document, const PlaceRound& command)
{
    const glm::dvec3& normal = *command.normal;
    if (!std::isfinite(glm::dot(normal, normal)) || !(glm::length(normal) > 0))
        throw Rejected("field \"normal\" has no direction");
    if (!kind_of(document, command.around).has_surface)
        throw Rejected(fmt::format("field \"around\": {} has no surface of its own; name one of "
                                   "the objects in it",
                                   named(document, command.around)));
}

// Throws Rejected if an object carries it on which it does not lie.
void check_attached(const Attachment& attachment, const PlacementStep& step)
{
    check(attachment, step.sketch.samples.size());
    if (step.round)
        throw Rejected(
            "field \"attach\" is not needed: what goes round an object moves with it anyway");
    for (const AttachedHost& host : attachment.hosts)
        if (std::ranges::find(step.onto, host.object) == step.onto.end())
            throw Rejected(fmt::format("field \"attach\" names object {}, which it does not lie on",
                                       host.object));
}

// Attaches it to all objects that it lies on, if none of them lies on a stroke, so that their
// transforms are known without evaluation.
Attachment attached_to_all(const Document& document, const PlacementStep& step)
{
    Attachment out;
    for (const Id id : step.onto) {
        if (object(document, id).stroke)
            throw Rejected(fmt::format("field \"attach\" is missing: {} lies on a stroke itself, "
                                       "so the command must say where it is met",
                                       named(document, id)));
        out.hosts.push_back(attached_host(id, to_world(document, id), true));
    }
    return out;
}

// Names what it lies on after the step: " on Vase and Table", " on Vase and the ground".
std::string words_of_support(const StepDocuments& step, Id id)
{
    const Object* laid = step.is(id);
    if (!laid || !laid->stroke) return {};
    const bool ground = laid->stroke->parameters.on_ground;
    const std::vector<Id>& onto = laid->stroke->onto;
    if (onto.empty()) return ground ? " on the ground" : "";
    if (!ground) return " on " + names_in(step.after, onto);
    if (onto.size() == 2)
        return " on " + name_in(step.after, onto[0]) + ", " + name_in(step.after, onto[1]) +
               " and the ground";
    return " on " + names_in(step.after, onto) + " and the ground";
}

} // namespace

std::vector<Id> possible_bases(const Document& document, Id id)
{
    const std::set<Id> above = depending_on(document, {id});
    std::vector<Id> result;
    for (const auto& [other, ref] : document.objects)
        if (kind_of(*ref).has_surface && !above.contains(other) && visible(document, other))
            result.push_back(other);
    return result;
}

Document applied(Document document, const Place& command)
{
    if (command.copy) {
        Place laid = command;
        laid.object = document.next_id;
        laid.copy = false;
        document = applied(std::move(document), Duplicate{{command.object}, glm::dvec3(0)});
        return applied(std::move(document), laid);
    }
    check_can_be_laid(document, command.object);
    check_sketch(command.sketch);
    check_parameters(command.parameters);
    PlacementStep step{
        command.sketch,
        command.parameters,
        supports(document, command.object, command.onto, command.parameters.on_ground),
        {},
        command.attach};
    if (step.attach) check_attached(*step.attach, step);
    return with_changed(std::move(document), command.object, [&](Object& o) {
        o.stroke = std::move(step);
        forget_shaping(o);
    });
}

StepTitle title(const Place& c, const StepDocuments& step)
{
    const Object* object = step.was(c.object);
    const bool again = object && object->stroke;
    if (c.copy)
        return {"Place a copy of " + name_in(step.before, c.object) +
                    words_of_support(step, step.before.next_id),
                c.parameters.width > 0 ? in_metres(c.parameters.width) : std::string()};
    return {"Place " + name_in(step.before, c.object) + (again ? " again" : "") +
                words_of_support(step, c.object),
            c.parameters.width > 0 ? in_metres(c.parameters.width) : std::string()};
}

Document applied(Document document, const PlaceRound& command)
{
    check_can_be_laid(document, command.object);
    const Object& base = object(document, command.around);
    if (command.normal)
        check_cut(document, command);
    else if (!band_round(base.source, 0, glm::dmat4(1)))
        throw Rejected(
            fmt::format("field \"around\": {} is not a cylinder, sphere, torus or Moebius "
                        "band; name the plane that cuts it in \"normal\"",
                        named(document, command.around)));
    if (base.stroke)
        throw Rejected(fmt::format(
            "field \"around\": {} lies on a stroke itself; remove it from its stroke first",
            named(document, command.around)));
    check_parameters(command.parameters);
    PlacementStep step{{},
                       command.parameters,
                       supports(document, command.object, {command.around}),
                       RoundWay{command.level, command.normal}};
    return with_changed(std::move(document), command.object, [&](Object& o) {
        o.stroke = std::move(step);
        forget_shaping(o);
    });
}

StepTitle title(const PlaceRound& c, const StepDocuments& step)
{
    return {"Lay " + name_in(step.before, c.object) + " round " + name_in(step.before, c.around),
            {}};
}

Document applied(Document document, const EditPlacement& command)
{
    const Object& placed = object(document, command.object);
    check_placed(placed, command.object);
    check_parameters(command.parameters);
    PlacementStep step = *placed.stroke;
    step.parameters = command.parameters;
    if (command.sketch) {
        check_sketch(*command.sketch);
        step.sketch = *command.sketch;
        step.round.reset();
        step.attach.reset();
    }
    if (command.onto && step.round)
        throw Rejected(fmt::format(
            "field \"onto\": {} goes round object {}; use place_round for another object",
            placed.name, step.onto.empty() ? 0 : step.onto.front()));
    if (command.onto)
        step.onto = supports(document, command.object, *command.onto, step.parameters.on_ground);
    const PlacementStep& before = *placed.stroke;
    if (step.onto.empty() && before.parameters.on_ground && !step.parameters.on_ground)
        throw Rejected(
            fmt::format("{} lies on nothing but the ground; add or show another object and "
                        "name it in \"onto\"",
                        named(document, command.object)));
    if (command.attach) step.attach = command.attach;
    if (command.attach) check_attached(*step.attach, step);
    if (step.attach && command.onto)
        step.attach = renumbered(*step.attach, [&](Id id) -> std::optional<Id> {
            if (std::ranges::find(step.onto, id) == step.onto.end()) return {};
            return id;
        });
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.stroke = std::move(step); });
}

StepTitle title(const EditPlacement& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    const Object *a = step.was(c.object), *b = step.is(c.object);
    if (!a || !b || !a->stroke || !b->stroke) return {"Placement of " + name, {}};
    const Changes found = changes(a->stroke->parameters, b->stroke->parameters);
    if (auto moved = stroke_title(*a->stroke, *b->stroke, name)) return *moved;
    if (a->stroke->sketch != b->stroke->sketch) return {"Stroke of " + name, {}};
    if (found.empty() && a->stroke->onto != b->stroke->onto)
        return {"Lay " + name + words_of_support(step, c.object), {}};
    return title_of_changes(found, "Placement", name);
}

Document applied(Document document, const Attach& command)
{
    const Object& placed = object(document, command.object);
    check_placed(placed, command.object);
    PlacementStep step = *placed.stroke;
    step.attach = command.attach ? command.attach : attached_to_all(document, step);
    check_attached(*step.attach, step);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.stroke = std::move(step); });
}

StepTitle title(const Attach& c, const StepDocuments& step)
{
    std::vector<Id> hosts;
    if (const Object* o = step.is(c.object); o && o->stroke && o->stroke->attach)
        for (const AttachedHost& host : o->stroke->attach->hosts)
            if (host.touched) hosts.push_back(host.object);
    return {"Attach " + name_in(step.before, c.object) +
                (hosts.empty() ? std::string() : " to " + names_in(step.after, hosts)),
            {}};
}

Document applied(Document document, const Unplace& command)
{
    check_placed(object(document, command.object), command.object);
    return with_changed(std::move(document), command.object, [](Object& o) {
        o.stroke.reset();
        forget_shaping(o);
        o.travel = {};
        o.refining.reset();
    });
}

StepTitle title(const Unplace& c, const StepDocuments& step)
{
    return {"Take " + name_in(step.before, c.object) + " off its stroke", {}};
}

Document applied(Document document, const SetTravel& command)
{
    for (const Id id : distinct(document, command.objects)) {
        check_placed(object(document, id), id);
        if (is_lattice(document, id))
            throw Rejected(
                named(document, id) +
                " is a lattice, which does not travel; animate the start of its stroke instead");
    }
    if (command.travels.empty())
        return with_all_changed(std::move(document), command.objects,
                                [&](Object& o) { o.travel = command.travel; });
    if (command.travels.size() != command.objects.size())
        throw Rejected(fmt::format("field \"travels\" has {} entries for {} objects",
                                   command.travels.size(), command.objects.size()));
    for (std::size_t i = 0; i < command.objects.size(); ++i)
        document = with_changed(std::move(document), command.objects[i],
                                [&](Object& o) { o.travel = command.travels[i]; });
    return document;
}

StepTitle title(const SetTravel& c, const StepDocuments& step)
{
    const std::string names = names_in(step.before, c.objects);
    const Object* object = c.objects.empty() ? nullptr : step.was(c.objects.front());
    const Travel old = object ? object->travel : Travel{};
    const Travel& now = c.travels.empty() ? c.travel : c.travels.front();
    const std::string speed = number_text(now.speed) + " m/s";
    if (old.speed == 0 && now.speed != 0) return {"Let " + names + " travel", speed};
    if (old.speed != 0 && now.speed == 0) return {"Let " + names + " rest", {}};
    return title_of_changes(changes(old, now), "Travel", names);
}

} // namespace trivar
