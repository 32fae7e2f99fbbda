// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/incise.h"

namespace trivar {

struct PeelFlap {
    static constexpr std::string_view
        verb = "peel_flap",
        summary = "Bend the flap between two incisions that cross outward, or let it down to 0.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    PeeledFlap flap;
    bool operator==(const PeelFlap&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with incisions", required.names_object());
        spread(c.flap, field);
    }
};
Document applied(Document document, const PeelFlap& command);
StepTitle title(const PeelFlap& c, const StepDocuments& step);

struct LayFlap {
    static constexpr std::string_view
        verb = "lay_flap",
        summary = "Lay a flap that was peeled back for good; keys of the others stay with them.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    bool operator==(const LayFlap&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object with peeled flaps", required.names_object());
        field("number", c.number, "which of them, the first is 1", in_range(1, most_peeled_flaps));
    }
};
Document applied(Document document, const LayFlap& command);
StepTitle title(const LayFlap& c, const StepDocuments& step);

} // namespace trivar
