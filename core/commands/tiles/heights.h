// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/objects/set_shape.h"
#include "core/commands/words/step_title.h"

namespace trivar {

// Throws Rejected for heights without a picture.
void check(const HeightShape& shape);
std::string size_words(const HeightShape& shape);

using AddHeights = AddShape<HeightShape>;

template <> struct SetWords<HeightShape> {
    static constexpr std::string_view verb = "set_heights",
                                      summary = "Change a sheet of heights in place.",
                                      help = "id of a sheet of heights";
};
using SetHeights = SetShape<HeightShape>;
StepTitle title_of_change(const HeightShape* before, const HeightShape& now,
                          const std::string& name);

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
