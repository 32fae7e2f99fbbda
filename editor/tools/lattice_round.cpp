// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice_round.h"

#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/commands/numbering.h"
#include "core/commands/tetrahedra.h"
#include "core/simplex/cells_around.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// The group in which all of them are; 0: none.
Id common_parent(const Document& document, const std::vector<Id>& ids)
{
    const Id parent = object(document, ids.front()).parent;
    for (const Id id : ids)
        if (object(document, id).parent != parent) return 0;
    return parent;
}

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

AddTetrahedra tetrahedra_round(const Session& session, const std::vector<Id>& ids)
{
    const AddLattice lattice = lattice_round(session, ids);
    AddTetrahedra add{.objects = ids, .transform = lattice.transform};
    constexpr double margin = 1.05; // what is on the border is inside
    add.shape.size = lattice.shape.size * margin;
    const double shortest = std::min({add.shape.size.x, add.shape.size.y, add.shape.size.z});
    for (int i = 0; i < 3; ++i)
        add.shape.boxes[i] =
            std::clamp(static_cast<int>(std::lround(2 * add.shape.size[i] / shortest)), 2, 6);
    add.name = Numbering(session.document()).unique(add.name);
    return add;
}

// The vertices of objects in the space of the group that holds them.
std::vector<glm::dvec3> points_of(const Session& session, const std::vector<Id>& ids, Id parent)
{
    const glm::dmat4 world_to_parent =
        parent == 0 ? glm::dmat4(1) : glm::inverse(to_world(session.document(), parent));
    std::vector<glm::dvec3> out;
    for (const auto& [id, each] : session.evaluated().objects)
        if (std::ranges::any_of(
                ids, [&, id = id](Id of) { return belongs_to(session.document(), id, of); }))
            for (const Part& part : with_points(each->parts, each->curves)) {
                const glm::dmat4 to_parent = world_to_parent * part.to_world;
                for (const glm::vec3& p : part.mesh()->positions)
                    out.emplace_back(to_parent * glm::dvec4(glm::dvec3(p), 1));
            }
    return out;
}

// With cells that follow what they hold, instead of a box.
AddTetrahedra fitted_round(const Session& session, const std::vector<Id>& ids)
{
    AddTetrahedra add = tetrahedra_round(session, ids);
    std::vector<glm::dvec3> points =
        points_of(session, ids, common_parent(session.document(), ids));
    for (glm::dvec3& p : points) p -= add.transform.translation;
    const FilledCells filled = cells_around(points, {}, {});
    for (const glm::dvec3& v : filled.mesh.vertices)
        add.shape.vertices.emplace_back(rounded(v.x, 6), rounded(v.y, 6), rounded(v.z, 6));
    for (const auto& cell : filled.mesh.cells)
        add.shape.cells.emplace_back(cell[0], cell[1], cell[2], cell[3]);
    return add;
}

bool put_round(Session& session, const AddTetrahedra& add)
{
    const Id id = session.committed().next_id;
    if (!session.run(add)) return false;
    session.selected = id;
    return true;
}

} // namespace

bool put_tetrahedra_round_selection(Session& session)
{
    return put_round(session, tetrahedra_round(session, session.selected.ids()));
}

bool fit_tetrahedra_round_selection(Session& session)
{
    try {
        return put_round(session, fitted_round(session, session.selected.ids()));
    } catch (const Rejected& error) {
        session.notices.say(ui::NoticeKind::error, "No tetrahedra were made", error.what());
        return false;
    }
}

bool put_lattice_round_selection(Session& session)
{
    const Id id = session.committed().next_id;
    if (!session.run(lattice_round(session, session.selected.ids()))) return false;
    session.selected = id;
    return true;
}

} // namespace trivar
