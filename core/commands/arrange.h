// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

struct SetTransform {
    static constexpr std::string_view verb = "transform",
                                      summary = "Give an object a new transform, as a whole.";
    Id object = 0;
    Transform transform;
    bool operator==(const SetTransform&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required);
        FieldsOf<Transform>::fields(c.transform, field);
    }
};
struct Arrange {
    static constexpr std::string_view verb = "arrange",
                                      summary = "Give objects new transforms, one each.";
    std::vector<Id> objects;
    std::vector<Transform> transforms;
    bool operator==(const Arrange&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required);
        field("transforms", c.transforms, "of the objects, in the same order", required);
    }
};
struct Rename {
    static constexpr std::string_view verb = "rename", summary = "Give an object another name.";
    Id object = 0;
    std::string name;
    bool operator==(const Rename&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required);
        field("name", c.name, "the new name, not empty", required);
    }
};
struct Hide {
    static constexpr std::string_view verb = "hide", summary = "Leave objects out of the picture.";
    std::vector<Id> objects;
    bool operator==(const Hide&) const = default;
    static void fields(auto& c, auto&& field) { field("objects", c.objects, "ids", required); }
};
struct Show {
    static constexpr std::string_view verb = "show", summary = "Show hidden objects again.";
    std::vector<Id> objects;
    bool only = false;
    bool operator==(const Show&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required);
        field("only", c.only,
              "what is not in them is hidden, and the groups that they are in shown");
    }
};
struct Lock {
    static constexpr std::string_view verb = "lock",
                                      summary = "Keep objects from being picked, moved and deleted "
                                                "by hand.";
    std::vector<Id> objects;
    bool operator==(const Lock&) const = default;
    static void fields(auto& c, auto&& field) { field("objects", c.objects, "ids", required); }
};
struct Unlock {
    static constexpr std::string_view verb = "unlock", summary = "Let hands take objects again.";
    std::vector<Id> objects;
    bool operator==(const Unlock&) const = default;
    static void fields(auto& c, auto&& field) { field("objects", c.objects, "ids", required); }
};
struct Delete {
    static constexpr std::string_view verb = "delete",
                                      summary = "Delete objects, groups with what is in them. "
                                                "What lay on a deleted object no longer counts it.";
    std::vector<Id> objects;
    bool operator==(const Delete&) const = default;
    static void fields(auto& c, auto&& field) { field("objects", c.objects, "ids", required); }
};
struct Duplicate {
    static constexpr std::string_view verb = "duplicate",
                                      summary =
                                          "Copy objects, groups with what is in them. Copies "
                                          "that lay on each other lie on each other's copies.";
    std::vector<Id> objects;
    glm::dvec3 offset{0};
    bool operator==(const Duplicate&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids; the copies get the next ids in this order", required);
        field("offset", c.offset, "added to the copies' translation, metres");
    }
};
struct Group {
    static constexpr std::string_view verb = "group",
                                      summary = "Put objects into a new group; they stay in place.";
    std::vector<Id> objects;
    std::string name = "Group";
    bool operator==(const Group&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required);
        field("name", c.name, "name in the outliner");
    }
};
struct Ungroup {
    static constexpr std::string_view verb = "ungroup",
                                      summary = "Dissolve a group; what is in it stays in place, "
                                                "but for shear.";
    Id object = 0;
    bool operator==(const Ungroup&) const = default;
    static void fields(auto& c, auto&& field) { field("object", c.object, "id", required); }
};

struct Reorder {
    static constexpr std::string_view verb = "reorder",
                                      summary = "Give objects another place in the outliner, in a "
                                                "group or out of one; in the scene they stay where "
                                                "they are, but for shear.";
    std::vector<Id> objects;
    Id parent = 0, before = 0;
    bool operator==(const Reorder&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids, in their new order", required);
        field("parent", c.parent, "id of the group they go into; 0: none");
        field("before", c.before,
              "id of the one in that group that follows them; 0: they are last");
    }
};

} // namespace trivar
