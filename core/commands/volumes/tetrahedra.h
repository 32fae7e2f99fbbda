// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/objects/set_shape.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/simplex_sheet_fields.h"
#include "core/document/fields/tetrahedra_fields.h"

namespace trivar {

inline constexpr std::size_t most_tetrahedra_edits = 10000; // of one volume

// Throws Rejected for a volume that cannot be: flat, inverted or too many tetrahedra, edits that
// are none or several in one.
void check(const TetrahedraShape& shape);

std::string size_words(const SimplexSheetShape& shape);
using AddSimplexSheet = AddShape<SimplexSheetShape>;

template <> struct SetWords<SimplexSheetShape> {
    static constexpr std::string_view verb = "set_simplex_sheet",
                                      summary = "Change a surface of simplex splines.",
                                      help = "id of a surface of simplex splines", title = "Sheet";
};
using SetSimplexSheet = SetShape<SimplexSheetShape>;

struct AddTetrahedra {
    static constexpr std::string_view verb = "add_tetrahedra",
                                      summary =
                                          "Put a volume of tetrahedra round objects. They are its "
                                          "children, as in a group, and bend with it.";
    static constexpr CommandNature nature{.icon = CommandIcon::add,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    std::string name = "Tetrahedra";
    TetrahedraShape shape = {};
    Transform transform = {};
    bool operator==(const AddTetrahedra&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of the objects to bend", required.names_object());
        field("name", c.name, "name in the outliner");
        spread(c.shape, field);
        field("transform", c.transform,
              "transform of the volume, in the group that holds all objects");
    }
};
Document applied(Document document, const AddTetrahedra& command);
StepTitle title(const AddTetrahedra& c, const StepDocuments& step);

template <> struct SetWords<TetrahedraShape> {
    static constexpr std::string_view
        verb = "set_tetrahedra",
        summary = "Change the domain of a volume of tetrahedra, and what was done to it.",
        help = "id of a volume of tetrahedra", title = "Tetrahedra";
};
using SetTetrahedra = SetShape<TetrahedraShape>;

struct EditTetrahedra {
    static constexpr std::string_view verb = "edit_tetrahedra",
                                      summary = "Pull, warp, crease or refine a volume of "
                                                "tetrahedra, after what was done to it before.";
    Id object = 0;
    TetrahedraEdit edit = {};
    bool operator==(const EditTetrahedra&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a volume of tetrahedra", required.names_object());
        spread(c.edit, field);
    }
};
Document applied(Document document, const EditTetrahedra& command);
StepTitle title(const EditTetrahedra& c, const StepDocuments& step);

struct RemoveTetrahedraEdit {
    static constexpr std::string_view
        verb = "remove_tetrahedra_edit",
        summary = "Remove one edit of a volume of tetrahedra, and with a refinement the pulls of "
                  "it; keys of the others stay with them.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    bool operator==(const RemoveTetrahedraEdit&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a volume of tetrahedra", required.names_object());
        field("number", c.number, "of the edit, from 1 on", in_range(1, most_tetrahedra_edits));
    }
};
Document applied(Document document, const RemoveTetrahedraEdit& command);
StepTitle title(const RemoveTetrahedraEdit& c, const StepDocuments& step);

// Returns the words for an edit: "Pull by 0.2 m", "Cut along 12 places".
std::string words_of(const TetrahedraEdit& edit, int degree);

} // namespace trivar
