// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/set_shape.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/lattice_fields.h"

namespace trivar {

// Throws Rejected for control points that no lattice can have.
void check(const LatticeShape& shape);

struct AddLattice {
    static constexpr std::string_view verb = "add_lattice",
                                      summary =
                                          "Put a box of control points round objects. They are its "
                                          "children, as in a group, and bend with it.";
    static constexpr CommandNature nature{.icon = CommandIcon::add,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    std::string name = "Lattice";
    LatticeShape shape = {};
    Transform transform = {};
    bool in_place = false;
    bool operator==(const AddLattice&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of the objects to bend", required.names_object());
        field("name", c.name, "name in the outliner");
        spread(c.shape, field);
        field("transform", c.transform,
              "transform of the box, in the group that holds all objects");
        field("in_place", c.in_place,
              "whether it takes the row of the first object in the outliner; if not, it is the "
              "last row");
    }
};
Document applied(Document document, const AddLattice& command);
StepTitle title(const AddLattice& c, const StepDocuments& step);

template <> struct SetWords<LatticeShape> {
    static constexpr std::string_view
        verb = "set_lattice",
        summary = "Change the size and the control points of a lattice. Steps that move points it "
                  "no longer has are skipped; insert_knots keeps its shape.",
        help = "id of a lattice", title = "Lattice";
};
using SetLattice = SetShape<LatticeShape>;

} // namespace trivar
