// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/inside_field.h"
#include "core/split/splitting.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<SplitKernel>{"quadratic", "smooth",
                                                                           "gaussian", "hat"};

template <>
inline constexpr std::array<std::string_view, 4> choice_words<SplitKernel>{"soft", "smooth",
                                                                           "sharp", "linear"};

template <>
inline constexpr std::array<std::string_view, 3> choice_names<SplitClosing>{"open", "capped",
                                                                            "stitched"};
template <> inline constexpr bool was_switch<SplitClosing> = true;

template <>
inline constexpr std::array<std::string_view, 2> choice_names<SplitEnds>{"sharp", "smooth"};

template <> struct FieldsOf<ObstacleUse> {
    static constexpr std::string_view told_as = "[obstacle](#obstacle)",
                                      about = "What parts an object.";
    static void fields(auto& o, auto&& field)
    {
        field("object", o.object, "id of what parts it", required.names_object("split by"));
        field("clearance", o.clearance, "metres that stay free round the obstacle, at least",
              not_negative.called("Clearance").in(Unit::metres));
        field("reach", o.reach,
              "metres over which the opening fades away; widened to what is needed",
              not_negative.called("Reach").in(Unit::metres).zero_is("as needed"));
        field("kernel", o.kernel, "how the opening fades", any_value.called("Falloff"));
    }
};

template <> struct FieldsOf<Splitting> {
    static constexpr std::string_view told_as = "values of [split](#split)",
                                      copied_as = "values of [split](#split), and `known`";
    static void fields(auto& s, auto&& field)
    {
        field("obstacles", s.obstacles, "what parts it", required.without_keys());
        field("opening", s.opening, "direction in the world in which the halves part",
              any_value.called("Opens along").without_keys());
        field("way", s.way, "direction in the world in which it passes the obstacles",
              any_value.called("Passes along").without_keys());
        field("capped", s.closing,
              "how the halves are closed: not at all; by caps, so that they stay solid; or by "
              "stitching the skin together beside the obstacle, with nothing inside. false and "
              "true are read as open and capped",
              any_value.called("Closing"));
        inside_field(s.inside, field);
        field("tolerance", s.tolerance,
              "metres; its triangles are split until none is further from the true walls",
              in_range(1e-12, 1e9).called("Tolerance").in(Unit::metres));
        field("ends", s.ends,
              "how it opens before an obstacle and closes behind it: sharply, close to it; or "
              "smoothly, over a longer way",
              later.called("Ends"));
    }
};

} // namespace trivar
