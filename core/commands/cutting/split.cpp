// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/split.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

#include <fmt/format.h>
#include <set>

namespace trivar {

void check_splitting(const Document& document, Id id, const Splitting& splitting)
{
    const Object& own = object(document, id);
    check_has_surface(document, id, "split");
    if (splitting.obstacles.empty()) throw Rejected("field \"obstacles\" names no object");
    if (splitting.obstacles.size() > most_obstacles)
        throw Rejected(fmt::format("field \"obstacles\" has {} entries but at most {} are taken",
                                   splitting.obstacles.size(), most_obstacles));
    const double across = glm::length(glm::cross(splitting.opening, splitting.way));
    if (!(across > 1e-6 * glm::length(splitting.opening) * glm::length(splitting.way)))
        throw Rejected("fields \"opening\" and \"way\" must be two different directions");
    std::set<Id> seen;
    const std::set<Id> above = depending_on(document, {id});
    for (const ObstacleUse& each : splitting.obstacles) {
        const Object& other = object(document, each.object);
        if (!kind_of(other).has_surface)
            throw Rejected(named(each.object, other) +
                           " has no shape of its own; choose the objects in it as obstacles");
        if (above.contains(each.object))
            throw Rejected(named(id, own) + " cannot be parted by " + named(each.object, other) +
                           ", whose shape depends on it");
        if (!seen.insert(each.object).second)
            throw Rejected("field \"obstacles\" names " + named(each.object, other) + " twice");
    }
}

Document applied(Document document, const Split& command)
{
    for (const Id id : distinct(document, command.objects))
        check_splitting(document, id, command.splitting);
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.splitting = command.splitting; });
}

StepTitle title(const Split& c, const StepDocuments& step)
{
    std::vector<Id> by;
    for (const ObstacleUse& each : c.splitting.obstacles) by.push_back(each.object);
    return {"Split " + names_in(step.before, c.objects) + " at " + names_in(step.before, by), {}};
}

} // namespace trivar
