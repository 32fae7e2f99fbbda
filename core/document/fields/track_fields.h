// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<Tween>{"step", "linear", "cubic",
                                                                     "settle"};

template <>
inline constexpr std::array<std::string_view, 3> choice_names<Repeat>{"once", "loop",
                                                                      "back_and_forth"};

template <> struct FieldsOf<Key> {
    static constexpr std::string_view told_as = "[key](#key)",
                                      about = "A value in a frame, and how it goes on.";
    static void fields(auto& k, auto&& field)
    {
        field("frame", k.frame, "frame of the key, which may lie between two frames",
              required_in_range(-1e6, 1e6));
        field("value", k.value,
              "value of the parameter; switches are 0 and 1, choices are counted from 0 in their "
              "order",
              required);
        field(
            "tween", k.tween,
            "interpolation to the next key: none, linear, a Bezier curve, or swinging past it and "
            "back; whole numbers, choices and switches are always held");
        field("before", k.before,
              "the handle toward the previous key, [frames, value] from this key; zeros: a smooth "
              "one");
        field("after", k.after, "the handle toward the next key");
    }
};

template <> struct FieldsOf<Track> {
    static constexpr std::string_view told_as = "[track](#track)",
                                      about = "How one number goes from key to key.";
    static void fields(auto& t, auto&& field)
    {
        field("parameter", t.parameter,
              "name of a number of the object, such as transform.translation.z, or of the scene, "
              "such as render.exposure",
              required.names_nothing("a number in the scene"));
        field("keys", t.keys, "ascending by frame; none: it is no longer animated");
        field("repeat", t.repeat,
              "what comes after the last key: the last value, all keys again, or back and forth");
    }
};

} // namespace trivar
