// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/numbering.h"
#include "core/commands/objects/group.h"
#include "core/commands/words/field_words.h"
#include "core/commands/words/transform_title.h"
#include "core/document/bases.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Shows the chosen objects, the groups that they are in, and their contents unless these are hidden
// themselves.
Document with_only(Document document, const std::set<Id>& chosen)
{
    std::set<Id> seen = chosen;
    for (Id id : chosen)
        while ((id = object(document, id).parent) != 0) seen.insert(id);
    const std::set<Id> inside = with_contents(document, chosen);
    const ObjectMap objects = document.objects;
    for (const auto& [id, ref] : objects) {
        const bool hidden = seen.contains(id) ? false : inside.contains(id) ? ref->hidden : true;
        if (hidden != ref->hidden)
            document = with_changed(std::move(document), id, [&](Object& o) { o.hidden = hidden; });
    }
    return document;
}

// Several objects keep their relative places: if they rotate or scale about a point, the title does
// not mention that they also move.
StepTitle arranged_title(const Document& before, const Arrange& c)
{
    const auto was = [&](std::size_t i) -> Transform {
        const auto found = before.objects.find(c.objects[i]);
        return found == before.objects.end() ? Transform{} : found->second->transform;
    };
    const std::size_t count = std::min(c.objects.size(), c.transforms.size());
    const std::string names = names_in(before, c.objects);
    if (count == 0) return {"Arrange " + names, {}};
    if (count == 1) return transform_title(was(0), c.transforms[0], names);
    bool turned = false, scaled = false;
    for (std::size_t i = 0; i < count; ++i) {
        turned = turned || was(i).rotation_deg != c.transforms[i].rotation_deg;
        scaled = scaled || was(i).scale != c.transforms[i].scale;
    }
    const Transform first = was(0), &now = c.transforms[0];
    if (turned && scaled) return {"Rotate and scale " + names, {}};
    if (turned) return {"Rotate " + names, turn_words(first.rotation_deg, now.rotation_deg)};
    if (scaled) return {"Scale " + names, growth_words(first.scale, now.scale)};
    return {"Move " + names, in_metres(glm::length(now.translation - first.translation))};
}

// Removes the chosen objects and the contents of groups and lattices among them, and adds them to
// `gone`. A child of another deleted object stays in place, with the parent of that object.
Document without(Document document, const std::set<Id>& chosen, std::set<Id>& gone)
{
    const std::set<Id> below = with_contents(document, chosen);
    const auto goes = [&](Id id) {
        for (Id at = id; at != 0;) {
            if (chosen.contains(at)) return true;
            at = object(document, at).parent;
            if (at == 0 || !kind_of(document, at).holds_others) return false;
        }
        return false;
    };
    for (const Id id : below)
        if (goes(id)) gone.insert(id);
    for (const Id id : below) {
        Id parent = object(document, id).parent;
        if (gone.contains(id) || !gone.contains(parent)) continue;
        while (gone.contains(parent)) parent = object(document, parent).parent;
        document = with_parent(std::move(document), id, parent);
    }
    for (const Id id : gone) document.objects.erase(id);
    return document;
}

} // namespace

Document applied(Document document, const SetTransform& command)
{
    check_transform(command.transform);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.transform = command.transform; });
}

StepTitle title(const SetTransform& c, const StepDocuments& step)
{
    const Object* object = step.was(c.object);
    return transform_title(object ? object->transform : Transform{}, c.transform,
                           name_in(step.before, c.object));
}

Document applied(Document document, const Arrange& command)
{
    distinct(document, command.objects);
    if (command.transforms.size() != command.objects.size())
        throw Rejected(fmt::format("field \"transforms\" has {} entries for {} objects",
                                   command.transforms.size(), command.objects.size()));
    for (std::size_t i = 0; i < command.objects.size(); ++i) {
        check_transform(command.transforms[i]);
        document = with_changed(std::move(document), command.objects[i],
                                [&](Object& o) { o.transform = command.transforms[i]; });
    }
    return document;
}

StepTitle title(const Arrange& c, const StepDocuments& step)
{
    return arranged_title(step.before, c);
}

Document applied(Document document, const Rename& command)
{
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.name = command.name; });
}

StepTitle title(const Rename& c, const StepDocuments& step)
{
    return {"Rename " + name_in(step.before, c.object) + " to " + c.name, {}};
}

Document applied(Document document, const Show& command)
{
    if (command.only) return with_only(std::move(document), distinct(document, command.objects));
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.hidden = false; });
}

StepTitle title(const Show& c, const StepDocuments& step)
{
    return {(c.only ? "Show only " : "Show ") + names_in(step.before, c.objects), {}};
}

Document applied(Document document, const Delete& command)
{
    std::set<Id> gone;
    document = without(std::move(document), distinct(document, command.objects), gone);
    const auto is_gone = [&](Id id) { return gone.contains(id); };
    const ObjectMap rest = document.objects;
    for (const auto& [id, ref] : rest)
        if (std::ranges::any_of(bases_of(*ref), is_gone, &BaseUse::base))
            document.objects.set(
                id, make_ref(with_bases(*ref, [&](Id base) { return is_gone(base) ? 0 : base; })));
    return document;
}

Document applied(Document document, const Duplicate& command)
{
    const std::set<Id> chosen = distinct(document, command.objects);
    const std::set<Id> all = with_contents(document, chosen);
    // Copies get their ids in the order of the command, then by id for contents of groups.
    std::vector<Id> order = command.objects;
    for (const Id id : all)
        if (!chosen.contains(id)) order.push_back(id);
    std::map<Id, Id> copy_of;
    for (std::size_t i = 0; i < order.size(); ++i)
        copy_of[order[i]] = document.next_id + static_cast<Id>(i);
    const auto renumbered = [&](Id id) { return copy_of.contains(id) ? copy_of.at(id) : id; };
    Numbering numbering(document);
    for (const Id id : order) {
        Object copy = object(document, id);
        const bool inside = copy_of.contains(copy.parent);
        copy.parent = renumbered(copy.parent);
        if (!inside) { // contents of a copied group move with it
            copy.name = numbering.next(copy.name);
            copy.transform.translation += command.offset;
        }
        document = with_added(std::move(document), with_bases(std::move(copy), renumbered));
    }
    return document;
}

StepTitle title(const Duplicate& c, const StepDocuments& step)
{
    const double distance = glm::length(c.offset);
    return {"Duplicate " + names_in(step.before, c.objects),
            distance > 0 ? in_metres(distance) : std::string()};
}

} // namespace trivar
