// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/left_behind.h"

#include "core/placement/attachment.h"
#include "editor/commands/clipboard.h"

#include <algorithm>

namespace trivar {
namespace {

bool carried_object(const std::optional<PlacementStep>& step)
{
    return step && step->attach && carries(*step->attach);
}

} // namespace

std::vector<std::string> left_behind(const Document& before, const Document& after)
{
    const auto is_gone = [&](const AttachedHost& host) {
        return host.touched && !after.objects.contains(host.object);
    };
    std::vector<Id> with_the_rest, where_drawn, straight;
    for (const auto& [id, ref] : after.objects) {
        if (!ref->stroke || !before.objects.contains(id)) continue;
        const std::optional<PlacementStep>& was = object(before, id).stroke;
        if (!carried_object(was) || std::ranges::none_of(was->attach->hosts, is_gone)) continue;
        const PlacementStep& is = *ref->stroke;
        if (carried_object(is))
            with_the_rest.push_back(id);
        else if (!is.onto.empty() || is.parameters.on_ground)
            where_drawn.push_back(id);
        else
            straight.push_back(id);
    }
    std::vector<std::string> out;
    const auto say = [&](const std::vector<Id>& ids, const char* of_one, const char* of_several) {
        if (!ids.empty())
            out.push_back(said_of(after, ids) + (ids.size() == 1 ? of_one : of_several));
    };
    say(with_the_rest, " goes with the rest of what carried it.",
        " go with the rest of what carried them.");
    say(where_drawn, " goes with nothing now and lies where it was drawn.",
        " go with nothing now and lie where they were drawn.");
    say(straight, " has nothing left to lie on and stands straight. Place it anew.",
        " have nothing left to lie on and stand straight. Place them anew.");
    return out;
}

} // namespace trivar
