// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/lattice_round.h"

#include "core/commands/edits/numbering.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cmath>

namespace trivar {

Id common_parent(const Document& document, const std::vector<Id>& ids)
{
    if (ids.empty()) return 0;
    const Id parent = object(document, ids.front()).parent;
    for (const Id id : ids)
        if (object(document, id).parent != parent) return 0;
    return parent;
}

namespace {

// The box round objects, in the space of the group that holds them.
Box box_round(const Session& session, const std::vector<Id>& ids, Id parent)
{
    const glm::dmat4 world_to_parent =
        parent == 0 ? glm::dmat4(1) : glm::inverse(to_world(session.document(), parent));
    Box box;
    for (const auto& [id, each] : session.evaluated().objects)
        if (std::ranges::any_of(
                ids, [&, id = id](Id of) { return belongs_to(session.document(), id, of); }))
            for (Part& part : with_points(each->parts, each->curves)) {
                part.to_world = world_to_parent * part.to_world;
                box.add(bounds_in_world(part));
            }
    return box;
}

} // namespace

AddLattice lattice_round(const Session& session, const std::vector<Id>& ids)
{
    const Id parent = common_parent(session.document(), ids);
    const Box box = box_round(session, ids, parent);
    AddLattice add{.objects = ids, .in_place = true};
    if (box.empty()) return add;
    const double longest = std::max({box.size().x, box.size().y, box.size().z, 1e-6});
    constexpr double least_share = 0.05; // what is flat gets a thickness
    add.shape.size = glm::max(box.size(), glm::dvec3(least_share * longest));
    add.transform.translation = box.center();
    const double shortest = std::min({add.shape.size.x, add.shape.size.y, add.shape.size.z});
    for (int i = 0; i < 3; ++i)
        add.shape.grid[i] =
            std::clamp(static_cast<int>(std::lround(3 * add.shape.size[i] / shortest)) + 1, 4, 8);
    add.name = Numbering(session.document()).unique(add.name);
    return add;
}

bool put_lattice_round_selection(Session& session)
{
    const Id id = session.committed().next_id;
    if (!session.run(lattice_round(session, session.selected.ids()))) return false;
    session.selected = id;
    return true;
}

} // namespace trivar
