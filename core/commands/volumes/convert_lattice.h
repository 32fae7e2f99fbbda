// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/command_nature.h"
#include "core/commands/words/step_title.h"
#include "core/document/document.h"
#include "core/document/field.h"

namespace trivar {

struct ConvertLattice {
    static constexpr std::string_view
        verb = "convert_lattice",
        summary = "Turn a lattice into a volume of tetrahedra that deforms what is in it the same "
                  "way, to a deviation that the volume states, and can be refined and cut "
                  "anywhere. Keys of the lattice itself go.";
    Id object = 0;
    int pieces = 2;
    int degree = 3;
    bool operator==(const ConvertLattice&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required.names_object());
        field("pieces", c.pieces,
              "into which each span between its knots is cut along each axis: the more, the nearer",
              in_range(1, 16));
        field("degree", c.degree, "of the splines: 1 linear, 2 quadratic, 3 cubic", in_range(1, 3));
    }
};
Document applied(Document document, const ConvertLattice& command);
StepTitle title(const ConvertLattice& c, const StepDocuments& step);

} // namespace trivar
