// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/group.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

glm::dmat4 parent_to_world(const Document& document, Id parent)
{
    return parent == 0 ? glm::dmat4(1) : to_world(document, parent);
}

// Largest depth of a tree: every look at an object walks up to its root.
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

// Leaves out objects that are inside another one of them, because they move with it.
std::vector<Id> outermost(const Document& document, const std::vector<Id>& ids)
{
    const std::set<Id> chosen = distinct(document, ids);
    std::vector<Id> result;
    for (const Id id : ids)
        if (!inside_one_of(document, id, chosen)) result.push_back(id);
    return result;
}

// Throws Rejected if one of the members is that parent, or contains it.
void check_no_ring(const Document& document, const std::vector<Id>& members, Id parent)
{
    for (Id id = parent; id != 0; id = object(document, id).parent)
        if (std::ranges::find(members, id) != members.end())
            throw Rejected(id == parent
                               ? named(document, id) + " cannot be in itself"
                               : fmt::format("{} cannot be in {}, which is in it",
                                             named(document, id), named(document, parent)));
    std::vector<Id> lattices = lattices_round(document, parent);
    if (is_lattice(document, parent)) lattices.push_back(parent);
    if (lattices.empty()) return;
    const std::set<Id> above =
        depending_on(document, with_contents(document, {members.begin(), members.end()}));
    for (const Id lattice : lattices)
        if (above.contains(lattice))
            throw Rejected(fmt::format("{} cannot be in {}, which lies on it",
                                       named(document, members.front()), named(document, lattice)));
}

} // namespace

// A placed object is in the world without its transform; it keeps the transform for when it is
// removed from its stroke.
Document with_parent(Document document, Id id, Id parent)
{
    const glm::dmat4 from = parent_to_world(document, object(document, id).parent);
    const glm::dmat4 to = parent_to_world(document, parent);
    return with_changed(std::move(document), id, [&](Object& o) {
        if (from != to && !o.stroke)
            o.transform = decomposed(glm::inverse(to) * from * o.transform.matrix());
        o.parent = parent;
    });
}

void check_own_depth(const Document& document, Id id)
{
    if (depth(document, id) > deepest)
        throw Rejected(fmt::format("groups nest at most {} deep", deepest));
}

void check_depth(const Document& document, Id group)
{
    for (const Id id : with_contents(document, {group})) check_own_depth(document, id);
}

Document with_parent_of(Document document, const std::vector<Id>& objects, Object holder)
{
    if (holder.name.empty()) throw Rejected("field \"name\" is empty");
    const std::vector<Id> members = outermost(document, objects);
    holder.parent = object(document, members.front()).parent;
    for (const Id id : members)
        if (object(document, id).parent != holder.parent) holder.parent = 0;
    const Id group = document.next_id;
    document = with_added(std::move(document), std::move(holder));
    for (const Id id : members) document = with_parent(std::move(document), id, group);
    check_depth(document, group);
    return document;
}

Document applied(Document document, const Group& command)
{
    return with_parent_of(std::move(document), command.objects,
                          {.name = command.name,
                           .source = GroupShape{},
                           .transform = {},
                           .surfacing = {},
                           .stroke = {}});
}

StepTitle title(const Group& c, const StepDocuments& step)
{
    return {"Group " + names_in(step.before, c.objects), c.name == "Group" ? "" : "as " + c.name};
}

Document applied(Document document, const Ungroup& command)
{
    const Object& group = object(document, command.object);
    if (!kind_of(group).holds_others)
        throw Rejected(named(document, command.object) + " is not a group");
    const Id parent = group.parent;
    std::vector<Id> members;
    for (const auto& [id, ref] : document.objects)
        if (ref->parent == command.object) members.push_back(id);
    for (const Id id : members) document = with_parent(std::move(document), id, parent);
    document.objects.erase(command.object);
    return document;
}

StepTitle title(const Ungroup& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    if (is_lattice(step.before, c.object)) return {"Delete " + name, "back to rest"};
    return {"Ungroup " + name, {}};
}

Document applied(Document document, const SetParent& command)
{
    const std::vector<Id> members = outermost(document, command.objects);
    if (command.parent != 0) {
        if (object(document, command.parent).stroke && !is_lattice(document, command.parent))
            throw Rejected(fmt::format(
                "{} lies on a stroke and cannot be a parent; place the other object on it instead",
                named(document, command.parent)));
        check_no_ring(document, members, command.parent);
    }
    for (const Id id : members) document = with_parent(std::move(document), id, command.parent);
    for (const Id id : members) check_depth(document, id);
    return document;
}

StepTitle title(const SetParent& c, const StepDocuments& step)
{
    const std::string names = names_in(step.before, c.objects);
    if (c.parent == 0) return {"Free " + names + " from what it goes with", {}};
    return {"Let " + names + " go with " + name_in(step.before, c.parent), {}};
}

Document applied(Document document, const Reorder& command)
{
    const std::vector<Id> members = outermost(document, command.objects);
    const auto moves = [&](Id id) { return std::ranges::find(members, id) != members.end(); };
    const Id parent = command.parent, before = command.before;
    if (parent != 0) {
        const Object& group = object(document, parent);
        if (!kind_of(group).holds_others)
            throw Rejected(named(document, parent) + " is not a group");
        check_no_ring(document, members, parent);
    }
    if (before != 0 && (object(document, before).parent != parent || moves(before)))
        throw Rejected(
            fmt::format("field \"before\" names object {}, which is not among the others "
                        "in that group",
                        before));
    std::vector<Id> rows = in_row_order(document);
    std::erase_if(rows, moves);
    const auto at = before == 0 ? rows.end() : std::ranges::find(rows, before);
    rows.insert(at, members.begin(), members.end());
    for (const Id id : members)
        if (object(document, id).parent != parent)
            document = with_parent(std::move(document), id, parent);
    if (parent != 0) check_depth(document, parent);
    document.rows = make_ref(std::move(rows));
    return document;
}

StepTitle title(const Reorder& c, const StepDocuments& step)
{
    const std::string names = names_in(step.before, c.objects);
    const Object* first = c.objects.empty() ? nullptr : step.was(c.objects.front());
    if (!first || first->parent == c.parent) return {"Reorder " + names, {}};
    if (c.parent == 0)
        return {"Take " + names + " out of " + name_in(step.before, first->parent), {}};
    return {"Put " + names + " into " + name_in(step.before, c.parent), {}};
}

} // namespace trivar
