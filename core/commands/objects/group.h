// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/field.h"

#include <vector>

namespace trivar {

// The document with `holder` as the parent of those objects, which keep their places in the world.
Document with_parent_of(Document document, const std::vector<Id>& objects, Object holder);

// The document with an object in another group, or below another object; it stays where it stands.
Document with_parent(Document document, Id id, Id parent);

// Throws Rejected where groups below this one nest too deep.
void check_depth(const Document& document, Id group);
// checks only how deep the group itself stands
void check_own_depth(const Document& document, Id id);

struct Group {
    static constexpr std::string_view verb = "group",
                                      summary = "Group objects; they stay in place.";
    static constexpr CommandNature nature{.icon = CommandIcon::group,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    std::string name = "Group";
    bool operator==(const Group&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
        field("name", c.name, "name in the outliner");
    }
};
Document applied(Document document, const Group& command);
StepTitle title(const Group& c, const StepDocuments& step);

struct Ungroup {
    static constexpr std::string_view
        verb = "ungroup",
        summary = "Dissolve a group; its contents stay in place, except that shear is lost.";
    static constexpr CommandNature nature{.icon = CommandIcon::group,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    bool operator==(const Ungroup&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required.names_object());
    }
};
Document applied(Document document, const Ungroup& command);
StepTitle title(const Ungroup& c, const StepDocuments& step);

struct SetParent {
    static constexpr std::string_view
        verb = "parent",
        summary = "Parent objects to another one; they stay in place, except that shear is lost.";
    static constexpr CommandNature nature{.icon = CommandIcon::group,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    Id parent = 0;
    bool operator==(const SetParent&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
        field("parent", c.parent,
              "id of the parent: a group, a lattice or any object that lies on no stroke; 0: none",
              any_value.names_object());
    }
};
Document applied(Document document, const SetParent& command);
StepTitle title(const SetParent& c, const StepDocuments& step);

struct Reorder {
    static constexpr std::string_view
        verb = "reorder",
        summary = "Move objects in the outliner, into a group or out of one; in the scene they "
                  "stay in place, except that shear is lost.";
    std::vector<Id> objects;
    Id parent = 0, before = 0;
    bool operator==(const Reorder&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids, in their new order", required.names_object());
        field("parent", c.parent, "id of the group they go into; 0: none",
              any_value.names_object());
        field("before", c.before,
              "id of the object in that group that follows them; 0: they are last",
              any_value.names_object());
    }
};
Document applied(Document document, const Reorder& command);
StepTitle title(const Reorder& c, const StepDocuments& step);

} // namespace trivar
