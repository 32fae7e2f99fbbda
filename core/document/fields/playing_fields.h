// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Playing> {
    static constexpr std::string_view told_as = "values of [play_clip](#play_clip)";
    static void fields(auto& p, auto&& field)
    {
        field("clip", p.clip, "animation clip to play; empty: rest pose",
              any_value.without_keys().names_nothing("part of a model's file"));
        field("speed", p.speed,
              "playback speed relative to the clip's own; negative plays backwards",
              in_range(-1e3, 1e3).in(Unit::times).without_keys());
        field("repeat", p.repeat,
              "what comes after the clip's end: the last pose, the clip again, or back and forth",
              any_value.without_keys());
        field("offset", p.offset, "seconds into the clip at the start frame",
              in_range(-1e6, 1e6).in(Unit::seconds));
        field("start_frame", p.start_frame, "the frame in which the clip starts",
              in_range(-999999, 999999).called("Start").in(Unit::at_frame).without_keys());
        field("foot_lock", p.foot_lock,
              "matches the walking speed to the clip so that planted feet do not slide",
              later.without_keys());
    }
};

} // namespace trivar
