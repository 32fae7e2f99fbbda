// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/shaping_fields.h"

namespace trivar {

struct WarpVolume {
    static constexpr std::string_view verb = "warp_volume",
                                      summary = "Twist, bend, taper, shear or bulge a lattice as "
                                                "a whole.";
    Id object = 0;
    Warp warp;
    bool operator==(const WarpVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required.names_object());
        spread(c.warp, field);
    }
};
Document applied(Document document, const WarpVolume& command);
StepTitle title(const WarpVolume& c, const StepDocuments& step);

struct SetWarp {
    static constexpr std::string_view verb = "set_warp",
                                      summary =
                                          "Change the numbers of an earlier warp of a lattice.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int step = 1;
    Warp warp;
    bool operator==(const SetWarp&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required.names_object());
        field("step", c.step, "number of the step that shaped it, from 1",
              required_in_range(1, 1e6));
        spread(c.warp, field);
    }
};
Document applied(Document document, const SetWarp& command);
StepTitle title(const SetWarp& c, const StepDocuments& step);

} // namespace trivar
