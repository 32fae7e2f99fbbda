// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/place_round.h"

#include "core/commands/place.h"
#include "core/document/band.h"
#include "core/placement/embed.h"
#include "editor/session/scene_facts.h"
#include "editor/tools/place.h"

#include <algorithm>

namespace trivar {
namespace {

bool goes_round(const Document& document, Id id)
{
    const Object& body = object(document, id);
    return !body.stroke && visible(document, id) &&
           band_round(body.source, 0, glm::dmat4(1)).has_value();
}

} // namespace

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
        if (goes_round(document, active) && can_be_laid(other)) return RoundWish{other, active};
        if (goes_round(document, other) && can_be_laid(active)) return RoundWish{active, other};
    }
    if (chosen.size() != 1 || !can_be_laid(chosen.front())) return {};
    const std::vector<Id> bodies = bodies_to_go_round(session, chosen.front());
    if (bodies.size() != 1) return {};
    return RoundWish{chosen.front(), bodies.front()};
}

void lay_round(Session& session, const RoundWish& wish)
{
    const Object& model = object(session.committed(), wish.model);
    PlaceRound command{wish.model, wish.around, 0, {}};
    if (model.stroke) {
        command.parameters = model.stroke->parameters;
        if (model.stroke->round) command.level = model.stroke->round->level;
    } else
        command.parameters = lengthwise({}, bounds_of(session, wish.model));
    if (!session.propose(command)) return session.cancel();
    session.commit_if_placed(wish.model);
    session.selected = wish.model;
}

} // namespace trivar
