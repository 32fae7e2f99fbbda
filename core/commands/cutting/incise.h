// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/incising_fields.h"

namespace trivar {

// The largest numbers of incisions and layers of one object, and of points of one stroke.
inline constexpr int most_incisions = 64;
inline constexpr std::size_t most_incision_layers = 16, most_incision_points = 10'000,
                             most_peeled_flaps = 256;

// The incisions of an object, and the place of one among them by its number. Throws Rejected where
// there are none, and none of that number.
const Incising& incising_of(const Document& document, Id id);
std::size_t incision_index(const Document& document, Id id, int number);

// Throws Rejected where a skin cannot be cut like that.
void check(const NamedIncision& incision);
void check(const Incising& incising);

struct Incise {
    static constexpr std::string_view
        verb = "incise",
        summary = "Cut into the skin of an object along a stroke over it, so that it opens; "
                  "incisions may cross, and ride with all that bends the object.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    NamedIncision incision;
    std::vector<IncisionLayer> layers = {};
    bool operator==(const Incise&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with a shape", required.names_object());
        spread(c.incision, field);
        field("layers", c.layers,
              "what walls show, where this is the first incision of the object; else they stay",
              later);
    }
};
Document applied(Document document, const Incise& command);
StepTitle title(const Incise& c, const StepDocuments& step);

struct EditIncision {
    static constexpr std::string_view verb = "edit_incision",
                                      summary = "Change one incision of an object.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    NamedIncision incision;
    bool operator==(const EditIncision&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with incisions", required.names_object());
        field("number", c.number, "which of them, the first is 1",
              required_in_range(1, most_incisions));
        field("stroke", c.incision.cut.stroke,
              "the points that it goes through; empty: the same as before");
        FieldsOf<NamedIncision>::numbers(c.incision, field);
    }
};
Document applied(Document document, const EditIncision& command);
StepTitle title(const EditIncision& c, const StepDocuments& step);

struct LayerIncisions {
    static constexpr std::string_view verb = "layer_incisions",
                                      summary =
                                          "Say what the walls of all incisions of objects show.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    std::vector<Id> objects;
    Incising incising; // its cuts do not count
    bool operator==(const LayerIncisions&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with incisions", required.names_object());
        FieldsOf<Incising>::layers(c.incising, field);
    }
};
Document applied(Document document, const LayerIncisions& command);
StepTitle title(const LayerIncisions& c, const StepDocuments& step);

struct SwapIncisions {
    static constexpr std::string_view
        verb = "swap_incisions",
        summary = "Exchange two incisions of an object in their order: where they cross, the one "
                  "that comes first is cut first.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int first = 1, second = 2;
    bool operator==(const SwapIncisions&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with incisions", required.names_object());
        field("first", c.first, "number of one of them", in_range(1, most_incisions));
        field("second", c.second, "number of the other one", in_range(1, most_incisions));
    }
};
Document applied(Document document, const SwapIncisions& command);
StepTitle title(const SwapIncisions& c, const StepDocuments& step);

struct RemoveIncision {
    static constexpr std::string_view
        verb = "remove_incision",
        summary = "Remove one incision of an object; keys of the others stay with them.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    bool operator==(const RemoveIncision&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with incisions", required.names_object());
        field("number", c.number, "which of them, the first is 1", in_range(1, most_incisions));
    }
};
Document applied(Document document, const RemoveIncision& command);
StepTitle title(const RemoveIncision& c, const StepDocuments& step);

struct OfClearIncisions {
    static constexpr std::string_view verb = "clear_incisions",
                                      summary = "Remove all incisions of objects.",
                                      help = "ids of objects with incisions",
                                      title = "Remove all incisions of {}";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
};
using ClearIncisions = OnObjects<OfClearIncisions>;
Document applied(Document document, const ClearIncisions& command);

} // namespace trivar
