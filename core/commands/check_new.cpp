// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/every_command.h"
#include "core/commands/objects/shape.h"
#include "core/placement/placement.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

glm::ivec3 knots_in(const KnotInsertion& k)
{
    return {k.along.size(), k.across.size(), k.up.size()};
}

double product(const glm::dvec3& n)
{
    return n.x * n.y * n.z;
}

// Bounds the number of control points of a lattice after its steps. A step that it could not take
// was skipped.
glm::ivec3 most_points(const Object& o, const LatticeShape& box)
{
    glm::ivec3 n = box.grid;
    for (const Ref<VolumeEdit>& edit : o.shaping) {
        if (edit->insertion)
            if (const glm::ivec3 then = n + knots_in(*edit->insertion);
                product(then) <= most_control_points)
                n = then;
        if (!edit->coarsening) continue;
        const int axis = static_cast<int>(edit->coarsening->axis);
        if (edit->coarsening->count >= box.orders[axis])
            n[axis] = std::min(n[axis], edit->coarsening->count);
    }
    return n;
}

void check_fits(const InsertKnots& c, const Object& o, const LatticeShape& box)
{
    const double then = product(most_points(o, box) + knots_in(c.insertion));
    if (then > most_control_points)
        throw Rejected(fmt::format("{} would have {} control points; a lattice may have {}", o.name,
                                   number_text(then), number_text(most_control_points)));
}

void check_fits(const MovePoints& c, const Object& o, const LatticeShape& box)
{
    const glm::ivec3 n = most_points(o, box);
    for (const glm::ivec3& p : c.shift.points)
        if (glm::any(glm::greaterThanEqual(p, n)))
            throw Rejected(fmt::format("field \"points\" names {}, {}, {}, but {} has {} x {} x {} "
                                       "control points, numbered from 0",
                                       p.x, p.y, p.z, o.name, n.x, n.y, n.z));
}

void check_fits(const CoarsenVolume& c, const Object& o, const LatticeShape& box)
{
    const int axis = static_cast<int>(c.coarsening.axis), count = c.coarsening.count;
    const int present = most_points(o, box)[axis], order = box.orders[axis];
    if (count >= present)
        throw Rejected(fmt::format("field \"count\" is {}, but {} has {} control points along {}; "
                                   "give fewer",
                                   count, o.name, present, "XYZ"[axis]));
    if (count < order)
        throw Rejected(fmt::format("field \"count\" is {}, but order {} needs at least {} control "
                                   "points along {}",
                                   count, order, order, "XYZ"[axis]));
}

template <class C> void check_lattice_takes(const Document& document, const C& command)
{
    const auto found = document.objects.find(command.object);
    if (found == document.objects.end()) return; // after() refuses it
    const Object& o = *found->second;
    if (const auto* box = std::get_if<LatticeShape>(&o.source)) check_fits(command, o, *box);
}

} // namespace

void check_effect(const Document& document, const InsertKnots& command)
{
    check_lattice_takes(document, command);
}

void check_effect(const Document& document, const MovePoints& command)
{
    check_lattice_takes(document, command);
}

void check_effect(const Document& document, const CoarsenVolume& command)
{
    check_lattice_takes(document, command);
}

void check_new(const Document& document, const Command& command)
{
    check(command);
    visit(
        [&](const auto& c) {
            if constexpr (requires { check_effect(document, c); }) check_effect(document, c);
        },
        command);
}

} // namespace trivar
