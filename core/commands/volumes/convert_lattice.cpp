// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/convert_lattice.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/placement/box_volume.h"
#include "core/placement/shaper.h"
#include "core/tetrahedra/from_lattice.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Each cell has 20 displacements; a field may hold that many cells.
constexpr double most_cells_of_lattice = 5000;

void check_count(const std::array<Knots, 3>& axes, const ConvertLattice& command)
{
    double cells = 6.0;
    for (const Knots& axis : axes)
        cells *= static_cast<double>(axis.breaks().size() - 1) * command.pieces;
    if (cells > most_cells_of_lattice)
        throw Rejected(fmt::format("the lattice would become {} tetrahedra; at most {} are "
                                   "allowed, with fewer pieces there are fewer",
                                   number_text(cells), number_text(most_cells_of_lattice)));
}

bool is_of_the_box(const Track& track)
{
    return track.parameter.starts_with("shape.") || track.parameter.starts_with("shaping.");
}

} // namespace

Document applied(Document document, const ConvertLattice& command)
{
    const Object& lattice = object(document, command.object);
    const auto* box = std::get_if<LatticeShape>(&lattice.source);
    if (!box)
        throw Rejected(
            fmt::format("field \"object\": {} is not a lattice", named(command.object, lattice)));
    if (lattice.stroke)
        throw Rejected(
            fmt::format("{} lies on a stroke; take it off first", named(command.object, lattice)));
    const Ref<Placement> at_rest = make_ref(place_box(box->size, box->grid, box->orders));
    const Lattice shaped = Shaper()(at_rest, lattice.shaping)->placement->volume;
    check_count(shaped.displacement.axes, command);
    TetrahedraShape shape =
        shape_of(from_lattice(shaped, {.degree = command.degree, .pieces = command.pieces}));
    shape.size = box->size;
    return with_changed(std::move(document), command.object, [&](Object& o) {
        o.source = std::move(shape);
        o.shaping.clear();
        std::vector<Track> left = o.tracks;
        std::erase_if(left, is_of_the_box);
        o.tracks = std::move(left);
    });
}

StepTitle title(const ConvertLattice& c, const StepDocuments& step)
{
    return {"Turn " + name_in(step.before, c.object) + " into tetrahedra", {}};
}

} // namespace trivar
