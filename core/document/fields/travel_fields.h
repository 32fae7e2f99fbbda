// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Travel> {
    static constexpr std::string_view told_as = "values of [set_travel](#set_travel)";
    static void fields(auto& t, auto&& field)
    {
        field("speed", t.speed,
              "speed along the stroke in metres per second; negative goes backwards, 0 stays; "
              "needs a fill below 1",
              in_range(-1e6, 1e6).in(Unit::metres_per_second).zero_is("not moving").without_keys());
        field("ends", t.ends,
              "what it does at the end of its stroke: it stops, disappears, goes straight on, goes "
              "on from the other end, or turns back",
              any_value.without_keys());
        field("ease_in", t.ease_in, "seconds from rest to full speed",
              in_range(0, 1e6).in(Unit::seconds).without_keys());
        field("ease_out", t.ease_out, "seconds from full speed to rest, where it stops or turns",
              in_range(0, 1e6).in(Unit::seconds).without_keys());
        field("start_frame", t.start_frame, "the frame in which it starts",
              in_range(-999999, 999999).called("Start").in(Unit::at_frame).without_keys());
        field("duration", t.duration, "seconds after which it stops wherever it is; 0: no limit",
              in_range(0, 1e6)
                  .called("Stops after")
                  .in(Unit::seconds)
                  .zero_is("unlimited")
                  .without_keys());
        field("followers", t.followers, "number of copies that follow it, one behind the other",
              later_in_range(0, 999).zero_is("none"));
        field("gap", t.gap,
              "metres along the middle of the volume from one to the next; 0: evenly along a loop, "
              "or one right behind the other",
              later_in_range(0, 1e6).in(Unit::metres).zero_is("by itself"));
        field("phase", t.phase,
              "share of the clip's period by which each is ahead of the one before",
              later_in_range(-1, 1));
    }
};

} // namespace trivar
