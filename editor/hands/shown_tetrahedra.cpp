// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/shown_tetrahedra.h"

#include "core/commands/edits/edits.h"

namespace trivar {

const EvaluatedObject* shown_tetrahedra(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    return found != session.evaluated().objects.end() && found->second->tetrahedra &&
                   tetrahedra_shape(session.document(), id) // which may be ahead
               ? &*found->second
               : nullptr;
}

const TetrahedraShape* tetrahedra_shape(const Document& document, Id id)
{
    return made_of<TetrahedraShape>(document, id);
}

const EvaluatedObject* selected_tetrahedra(const Session& session)
{
    return session.selected.size() == 1 ? shown_tetrahedra(session, session.selected) : nullptr;
}

Id tetrahedra_holding(const Session& session, Id id)
{
    if (id == 0 || !session.document().objects.contains(id)) return 0;
    if (tetrahedra_shape(session.document(), id)) return id;
    for (const Id up : lattices_round(session.document(), id))
        if (tetrahedra_shape(session.document(), up)) return up;
    return 0;
}

const TetrahedraOutcome* last_outcome(const Session& session, Id id)
{
    const EvaluatedObject* volume = shown_tetrahedra(session, id);
    return volume && !volume->tetrahedra->outcomes.empty() ? &volume->tetrahedra->outcomes.back()
                                                           : nullptr;
}

glm::dmat3 axes_of(const EvaluatedObject& volume)
{
    const glm::dvec3 x = glm::normalize(glm::dvec3(volume.tetrahedra_to_world[0]));
    const glm::dvec3 z = glm::normalize(glm::cross(x, glm::dvec3(volume.tetrahedra_to_world[1])));
    return {x, glm::cross(z, x), z};
}

double length_of(const EvaluatedObject& volume)
{
    return glm::length(glm::dvec3(volume.tetrahedra_to_world[0]));
}

} // namespace trivar
