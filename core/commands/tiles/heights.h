// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/words/step_title.h"

namespace trivar {

// Throws Rejected for heights without a picture.
void check(const HeightShape& shape);
std::string size_words(const HeightShape& shape);

using AddHeights = AddShape<HeightShape>;

struct SetHeights {
    static constexpr std::string_view verb = "set_heights",
                                      summary = "Change a sheet of heights in place.";
    Id object = 0;
    HeightShape shape;
    bool operator==(const SetHeights&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a sheet of heights", required.names_object());
        spread(c.shape, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetHeights> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<HeightShape>(&object.source);
        if (!own) return std::nullopt;
        return SetHeights{id, *own};
    }
};
Document applied(Document document, const SetHeights& command);
StepTitle title(const SetHeights& c, const StepDocuments& step);

struct Displace {
    static constexpr std::string_view
        verb = "displace",
        summary =
            "Displace an object by a picture, over each of its faces or over its UVs: cover it "
            "with a sheet of heights, each point P of it at P + h N. The object itself is "
            "hidden.";
    static constexpr CommandNature nature{.icon = CommandIcon::add,
                                          .asked = Invocation::by_actions};
    Id base = 0;
    int per_face = 1;
    HeightShape shape = {};
    std::optional<Surfacing> material = {};
    bool operator==(const Displace&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("base", c.base, "id of what is displaced", required.names_object());
        field("per_face", c.per_face, "how often the picture lies along each side of a face",
              in_range(1, 1000));
        spread(c.shape, field);
        field("material", c.material,
              "one material over all of it; left out: the object's, or "
              "nearly white");
    }
};
Document applied(Document document, const Displace& command);
StepTitle title(const Displace& c, const StepDocuments& step);

} // namespace trivar
