// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedra_round.h"

#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/commands/edits/numbering.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/meshing/cage_cells.h"
#include "core/meshing/hull_cells.h"
#include "editor/hands/lattice_round.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

struct Triangles {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<int, 3>> triangles;
};

// Returns the triangles of objects in the space of a group, less a way; of curves the points alone.
Triangles triangles_of(const Session& session, const std::vector<Id>& ids, Id parent,
                       const glm::dvec3& less)
{
    const glm::dmat4 world_to_parent =
        parent == 0 ? glm::dmat4(1) : glm::inverse(to_world(session.document(), parent));
    Triangles out;
    for (const auto& [id, each] : session.evaluated().objects)
        if (std::ranges::any_of(
                ids, [&, id = id](Id of) { return belongs_to(session.document(), id, of); }))
            for (const Part& part : with_points(each->parts, each->curves)) {
                const glm::dmat4 to_parent = world_to_parent * part.to_world;
                const auto first = static_cast<int>(out.positions.size());
                for (const glm::vec3& p : part.mesh()->positions)
                    out.positions.emplace_back(
                        glm::dvec3(to_parent * glm::dvec4(glm::dvec3(p), 1)) - less);
                for (const glm::uvec3& t : triangles(*part.mesh()))
                    out.triangles.push_back({first + static_cast<int>(t.x),
                                             first + static_cast<int>(t.y),
                                             first + static_cast<int>(t.z)});
            }
    return out;
}

AddTetrahedra box_of_tetrahedra(const Session& session, const std::vector<Id>& ids)
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

SimplexMesh<3> cells_of(Around around, const Triangles& model)
{
    if (around == Around::cage)
        return cage_cells(model.positions, model.triangles, {.edge = 0}).mesh;
    if (around == Around::hull) return hull_cells(model.positions, {}).mesh;
    return cells_around(model.positions, model.triangles, {}).mesh;
}

// Cells instead of a box.
AddTetrahedra filled_round(const Session& session, const std::vector<Id>& ids, Id cage,
                           Around around)
{
    AddTetrahedra add = box_of_tetrahedra(session, ids);
    const Triangles model =
        triangles_of(session, around == Around::cage ? std::vector{cage} : ids,
                     common_parent(session.document(), ids), add.transform.translation);
    const SimplexMesh<3> mesh = cells_of(around, model);
    for (const glm::dvec3& v : mesh.vertices)
        add.shape.vertices.emplace_back(rounded(v.x, 6), rounded(v.y, 6), rounded(v.z, 6));
    for (const auto& cell : mesh.cells)
        add.shape.cells.emplace_back(cell[0], cell[1], cell[2], cell[3]);
    return add;
}

} // namespace

bool put_tetrahedra_round_selection(Session& session, Around around)
{
    std::vector<Id> ids = session.selected.ids();
    const Id cage = session.selected, made = session.committed().next_id;
    const bool cage_apart = around == Around::cage && ids.size() > 1;
    if (cage_apart) std::erase(ids, cage);
    try {
        if (!session.run(around == Around::box ? box_of_tetrahedra(session, ids)
                                               : filled_round(session, ids, cage, around)))
            return false;
    } catch (const Rejected& error) {
        session.notices.say(ui::NoticeKind::error, "No tetrahedra were made", error.what());
        return false;
    }
    if (cage_apart) session.run(Hide{.objects = {cage}});
    session.selected = made;
    return true;
}

} // namespace trivar
