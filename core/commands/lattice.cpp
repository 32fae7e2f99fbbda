// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/lattice.h"

#include "core/base/rejected.h"
#include "core/commands/apply.h"

#include <fmt/format.h>

namespace trivar {

void check_lattice(const LatticeShape& shape)
{
    const double points = static_cast<double>(shape.grid.x) * shape.grid.y * shape.grid.z;
    if (points > most_control_points)
        throw Rejected(fmt::format("field \"grid\" makes {:.0f} control points; a lattice may have "
                                   "{:.0f}",
                                   points, most_control_points));
    for (int i = 0; i < 3; ++i)
        if (shape.grid[i] < shape.orders[i])
            throw Rejected(fmt::format("field \"grid\": order {} needs at least {} control points "
                                       "along {}, not {}",
                                       shape.orders[i], shape.orders[i], "XYZ"[i], shape.grid[i]));
}

Document applied(Document document, const AddLattice& command)
{
    check_lattice(command.shape);
    check_transform(command.transform);
    return with_parent_of(std::move(document), command.objects,
                          {.name = command.name,
                           .source = command.shape,
                           .transform = command.transform,
                           .surfacing = {},
                           .placement = {}});
}

Document applied(Document document, const SetLattice& command)
{
    const Object& lattice = object(document, command.object);
    if (!std::holds_alternative<LatticeShape>(lattice.source))
        throw Rejected(
            fmt::format("field \"object\": {} ({}) is no lattice", command.object, lattice.name));
    check_lattice(command.shape);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.source = command.shape; });
}

} // namespace trivar
