// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/document/commands/apply.h"

#include <fmt/format.h>

namespace trivar {
namespace {

glm::dmat4 parent_to_world(const Document& document, Id parent)
{
    return parent == 0 ? glm::dmat4(1) : to_world(document, parent);
}

// Hangs an object under another parent without moving it. What is placed lies in the world
// without its transform, and keeps that for the day it is taken off its stroke.
Document hung(Document document, Id id, Id parent)
{
    const glm::dmat4 from = parent_to_world(document, object(document, id).parent);
    const glm::dmat4 to = parent_to_world(document, parent);
    return with_changed(std::move(document), id, [&](Object& o) {
        if (from != to && !o.placement)
            o.transform = decomposed(glm::inverse(to) * from * o.transform.matrix());
        o.parent = parent;
    });
}

// Deeper trees have no use, and every look at an object walks up to its root.
constexpr int deepest = 64;

int depth(const Document& document, Id id)
{
    int result = 0;
    for (Id p = object(document, id).parent; p != 0; p = object(document, p).parent) ++result;
    return result;
}

bool inside_one_of(const Document& document, Id id, const std::set<Id>& ids)
{
    for (Id p = object(document, id).parent; p != 0; p = object(document, p).parent)
        if (ids.contains(p)) return true;
    return false;
}

} // namespace

Document applied(Document document, const Group& command)
{
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    const std::set<Id> chosen = distinct(document, command.objects);
    std::vector<Id> members; // what is inside another member comes along with it
    for (const Id id : command.objects)
        if (!inside_one_of(document, id, chosen)) members.push_back(id);
    Id parent = object(document, members.front()).parent;
    for (const Id id : members)
        if (object(document, id).parent != parent) parent = 0;
    const Id group = document.next_id;
    document = with_added(std::move(document), {.name = command.name,
                                                .source = GroupShape{},
                                                .transform = {},
                                                .surfacing = {},
                                                .parent = parent,
                                                .placement = {}});
    for (const Id id : members) document = hung(std::move(document), id, group);
    for (const Id id : with_contents(document, {group}))
        if (depth(document, id) > deepest)
            throw Rejected(fmt::format("groups nest at most {} deep", deepest));
    return document;
}

Document applied(Document document, const Ungroup& command)
{
    const Object& group = object(document, command.object);
    if (!std::holds_alternative<GroupShape>(group.source))
        throw Rejected(fmt::format("object {} ({}) is no group", command.object, group.name));
    const Id parent = group.parent;
    std::vector<Id> members;
    for (const auto& [id, ref] : document.objects)
        if (ref->parent == command.object) members.push_back(id);
    for (const Id id : members) document = hung(std::move(document), id, parent);
    document.objects.erase(command.object);
    return document;
}

} // namespace trivar
