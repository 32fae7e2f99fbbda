// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/lattice.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/group.h"
#include "core/commands/words/changes.h"
#include "core/placement/placement.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

void check(const LatticeShape& shape)
{
    const double points = static_cast<double>(shape.grid.x) * shape.grid.y * shape.grid.z;
    if (points > most_control_points)
        throw Rejected(fmt::format("field \"grid\" makes {} control points; a lattice may have "
                                   "{}",
                                   number_text(points), number_text(most_control_points)));
    for (int i = 0; i < 3; ++i)
        if (shape.grid[i] < shape.orders[i])
            throw Rejected(fmt::format("field \"grid\": order {} needs at least {} control points "
                                       "along {}, not {}",
                                       shape.orders[i], shape.orders[i], "XYZ"[i], shape.grid[i]));
}

namespace {

// Moves the row of an object before the first of the others.
Document with_row_before(Document document, Id id, const std::vector<Id>& others)
{
    std::vector<Id> rows = in_row_order(document);
    std::erase(rows, id);
    rows.insert(std::ranges::find_first_of(rows, others), id);
    document.rows = make_ref(std::move(rows));
    return document;
}

} // namespace

Document applied(Document document, const AddLattice& command)
{
    check(command.shape);
    check_transform(command.transform);
    const Id lattice = document.next_id;
    document = with_parent_of(std::move(document), command.objects,
                              {.name = command.name,
                               .source = command.shape,
                               .transform = command.transform,
                               .surfacing = {},
                               .stroke = {}});
    if (!command.in_place) return document;
    return with_row_before(std::move(document), lattice, command.objects);
}

StepTitle title(const AddLattice& c, const StepDocuments& step)
{
    return {"Put a lattice round " + names_in(step.before, c.objects),
            value_words(c.shape.grid, any_value)};
}

} // namespace trivar
