// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

struct SetLattice {
    static constexpr std::string_view
        verb = "set_lattice",
        summary = "Change the size and the control points of a lattice. Steps that move points it "
                  "no longer has are skipped; insert_knots keeps its shape.";
    Id object = 0;
    LatticeShape shape = {};
    bool operator==(const SetLattice&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required.names_object());
        spread(c.shape, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetLattice> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<LatticeShape>(&object.source);
        if (!own) return std::nullopt;
        return SetLattice{id, *own};
    }
};
Document applied(Document document, const SetLattice& command);
StepTitle title(const SetLattice& c, const StepDocuments& step);

} // namespace trivar
