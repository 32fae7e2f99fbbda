// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/apply.h"
#include "core/commands/numbering.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Shows those, what they are in and, as far as it is not hidden by itself, what is in them.
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

} // namespace

Document applied(Document document, const SetTransform& command)
{
    check_transform(command.transform);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.transform = command.transform; });
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

Document applied(Document document, const Rename& command)
{
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.name = command.name; });
}

Document applied(Document document, const Hide& command)
{
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.hidden = true; });
}

Document applied(Document document, const Show& command)
{
    if (command.only) return with_only(std::move(document), distinct(document, command.objects));
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.hidden = false; });
}

Document applied(Document document, const Lock& command)
{
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.locked = true; });
}

Document applied(Document document, const Unlock& command)
{
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.locked = false; });
}

Document applied(Document document, const Delete& command)
{
    const std::set<Id> gone = with_contents(document, distinct(document, command.objects));
    for (const Id id : gone) document.objects.erase(id);
    const auto is_gone = [&](Id id) { return gone.contains(id); };
    const ObjectMap rest = document.objects;
    for (const auto& [id, ref] : rest)
        if (ref->placement && std::ranges::any_of(ref->placement->onto, is_gone))
            document = with_changed(std::move(document), id,
                                    [&](Object& o) { std::erase_if(o.placement->onto, is_gone); });
    return document;
}

Document applied(Document document, const Duplicate& command)
{
    const std::set<Id> chosen = distinct(document, command.objects);
    const std::set<Id> all = with_contents(document, chosen);
    // Copies take their ids in the order of the command, then what is in groups by id.
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
        if (!inside) { // what is in a copied group moves with it
            copy.name = numbering.next(copy.name);
            copy.transform.translation += command.offset;
        }
        if (copy.placement)
            std::ranges::transform(copy.placement->onto, copy.placement->onto.begin(), renumbered);
        document = with_added(std::move(document), std::move(copy));
    }
    return document;
}

} // namespace trivar
