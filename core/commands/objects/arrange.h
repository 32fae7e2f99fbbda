// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/field.h"

namespace trivar {

struct SetTransform {
    static constexpr std::string_view verb = "transform",
                                      summary = "Set the whole transform of an object.";
    static constexpr CommandNature nature{.icon = CommandIcon::move};
    Id object = 0;
    Transform transform;
    bool operator==(const SetTransform&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required.names_object());
        spread(c.transform, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetTransform> as_it_is(const Object& object, Id id)
    {
        return SetTransform{id, object.transform};
    }
};
Document applied(Document document, const SetTransform& command);
StepTitle title(const SetTransform& c, const StepDocuments& step);

struct Arrange {
    static constexpr std::string_view verb = "arrange",
                                      summary = "Set the whole transforms of objects, one each.";
    static constexpr CommandNature nature{.icon = CommandIcon::move,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    std::vector<Transform> transforms;
    bool operator==(const Arrange&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
        field("transforms", c.transforms, "transforms of the objects, in the same order", required);
    }
};
Document applied(Document document, const Arrange& command);
StepTitle title(const Arrange& c, const StepDocuments& step);

struct Rename {
    static constexpr std::string_view verb = "rename", summary = "Rename an object.";
    static constexpr CommandNature nature{.icon = CommandIcon::rename,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    std::string name;
    bool operator==(const Rename&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required.names_object());
        field("name", c.name, "the new name, not empty", required);
    }
};
Document applied(Document document, const Rename& command);
StepTitle title(const Rename& c, const StepDocuments& step);

struct OfHide {
    static constexpr std::string_view verb = "hide", summary = "Hide objects.", help = "ids",
                                      title = "Hide {}";
    static constexpr CommandNature nature{.icon = CommandIcon::hide, .asked = Invocation::at_once};
    static void change(Object& o) { o.hidden = true; }
};
using Hide = OnObjects<OfHide>;

struct Show {
    static constexpr std::string_view verb = "show", summary = "Show hidden objects again.";
    static constexpr CommandNature nature{.icon = CommandIcon::show, .asked = Invocation::at_once};
    std::vector<Id> objects;
    bool only = false;
    bool operator==(const Show&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
        field("only", c.only, "hides everything else, and shows the groups that they are in");
    }
};
Document applied(Document document, const Show& command);
StepTitle title(const Show& c, const StepDocuments& step);

struct OfLock {
    static constexpr std::string_view
        verb = "lock",
        summary = "Protect objects from being picked, moved and deleted by hand.", help = "ids",
        title = "Lock {}";
    static constexpr CommandNature nature{.icon = CommandIcon::lock, .asked = Invocation::at_once};
    static void change(Object& o) { o.locked = true; }
};
using Lock = OnObjects<OfLock>;

struct OfUnlock {
    static constexpr std::string_view verb = "unlock", summary = "Unlock objects.", help = "ids",
                                      title = "Unlock {}";
    static constexpr CommandNature nature{.icon = CommandIcon::unlock,
                                          .asked = Invocation::at_once};
    static void change(Object& o) { o.locked = false; }
};
using Unlock = OnObjects<OfUnlock>;

struct OfDelete {
    static constexpr std::string_view verb = "delete",
                                      summary =
                                          "Delete objects, and groups with their contents. Objects "
                                          "that lay on a deleted one no longer use it.",
                                      help = "ids", title = "Delete {}";
    static constexpr CommandNature nature{.icon = CommandIcon::remove,
                                          .asked = Invocation::by_actions};
};
using Delete = OnObjects<OfDelete>;
Document applied(Document document, const Delete& command);

struct Duplicate {
    static constexpr std::string_view
        verb = "duplicate",
        summary = "Duplicate objects, and groups with their contents. Where one lay on another, "
                  "its copy lies on the other's copy.";
    static constexpr CommandNature nature{.icon = CommandIcon::copy,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects;
    glm::dvec3 offset{0};
    bool operator==(const Duplicate&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids; the copies get the next ids in this order",
              required.names_object());
        field("offset", c.offset, "added to the copies' translation, metres");
    }
};
Document applied(Document document, const Duplicate& command);
StepTitle title(const Duplicate& c, const StepDocuments& step);

} // namespace trivar
