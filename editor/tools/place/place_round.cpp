// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/place/place_round.h"

#include "core/base/rounded.h"
#include "core/commands/placement/place.h"
#include "core/document/band.h"
#include "core/placement/embed.h"
#include "core/placement/round.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "editor/tools/place/place.h"

#include <algorithm>

namespace trivar {
namespace {

bool goes_round(const Document& document, Id id)
{
    const Object& body = object(document, id);
    return !body.stroke && visible(document, id) && kind_of(body).has_surface &&
           !kind_of(body).is_flat;
}

glm::dvec3 direction_of(RoundAxis axis)
{
    glm::dvec3 out(0);
    out[static_cast<int>(axis)] = 1;
    return out;
}

// Returns the way from the origin of the body to its middle along an axis, in its own space.
double middle_level(const Session& session, Id body, RoundAxis axis)
{
    const Box seen = bounds_of(session, body);
    if (seen.empty()) return 0;
    const glm::dmat4 to_own = glm::inverse(to_world(session.document(), body));
    Box own;
    for (const glm::dvec3& p : seen.corners()) own.add(glm::dvec3(to_own * glm::dvec4(p, 1)));
    return rounded(glm::dot(own.center(), direction_of(axis)), 4);
}

} // namespace

Command round_command(const Session& session, const RoundWish& wish)
{
    const Object& model = object(session.committed(), wish.model);
    PlaceRound command{wish.model, wish.around, 0, {}};
    command.parameters =
        model.stroke ? model.stroke->parameters : lengthwise({}, bounds_of(session, wish.model));
    if (wish.axis != RoundAxis::z || !has_round_way(session.committed(), wish.around))
        command.normal = direction_of(wish.axis);
    const std::optional<RoundWish> now = round_now(session.committed(), wish.model);
    const bool same_way = now && now->around == wish.around && now->axis == wish.axis;
    if (wish.level)
        command.level = *wish.level;
    else if (same_way || (now && !command.normal))
        command.level = *now->level;
    else if (command.normal)
        command.level = middle_level(session, wish.around, wish.axis);
    return command;
}

bool has_round_way(const Document& document, Id id)
{
    return band_round(object(document, id).source, 0, glm::dmat4(1)).has_value();
}

std::vector<Id> bodies_to_go_round(const Session& session, Id model)
{
    std::vector<Id> out;
    for (const auto& [id, each] : session.document().objects)
        if (id != model && goes_round(session.document(), id)) out.push_back(id);
    return out;
}

std::optional<RoundWish> round_wish(const Session& session)
{
    const Document& document = session.document();
    const std::vector<Id> chosen = session.selected.ids();
    const auto can_be_laid = [&](Id id) {
        return can_be_placed(document, id) && !locked(document, id);
    };
    if (chosen.size() == 2) {
        const Id active = session.selected;
        const Id other = chosen[0] == active ? chosen[1] : chosen[0];
        for (const bool exact : {true, false})
            for (const auto& [model, body] : {std::pair(other, active), {active, other}})
                if (goes_round(document, body) && can_be_laid(model) &&
                    has_round_way(document, body) == exact)
                    return RoundWish{model, body};
    }
    if (chosen.size() != 1 || !can_be_laid(chosen.front())) return {};
    std::vector<Id> bodies = bodies_to_go_round(session, chosen.front());
    std::erase_if(bodies, [&](Id id) { return !has_round_way(document, id); });
    if (bodies.size() != 1) return {};
    return RoundWish{chosen.front(), bodies.front()};
}

std::optional<RoundWish> round_now(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    if (found == document.objects.end() || !found->second->stroke) return {};
    const PlacementStep& step = *found->second->stroke;
    if (!step.round || step.onto.empty()) return {};
    RoundWish out{id, step.onto.front(), RoundAxis::z, step.round->level};
    if (const auto& normal = step.round->normal)
        for (const RoundAxis axis : {RoundAxis::x, RoundAxis::y})
            if (*normal == direction_of(axis)) out.axis = axis;
    return out;
}

void lay_round(Session& session, const RoundWish& wish)
{
    if (!session.propose(round_command(session, wish))) return session.cancel();
    session.commit_if_placed(wish.model);
    session.selected = wish.model;
}

} // namespace trivar
