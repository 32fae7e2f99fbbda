// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 3> choice_names<Tween>{"step", "linear", "cubic"};

template <>
inline constexpr std::array<std::string_view, 3> choice_names<Repeat>{"once", "loop",
                                                                      "back_and_forth"};

template <> struct FieldsOf<Key> {
    static constexpr std::string_view told_as = "[key](#key)";
    static void fields(auto& k, auto&& field)
    {
        field("frame", k.frame, "when, between two frames too", required_in_range(-1e6, 1e6));
        field("value", k.value,
              "of the parameter then; switches are 0 and 1, choices count from 0 in the order in "
              "which they are listed",
              required);
        field("tween", k.tween,
              "how it goes on to the next key: it stays, straight, or along a Bezier curve; whole "
              "numbers, choices and switches always stay");
        field("before", k.before,
              "the curve's inner control point toward the key before, [frames, value] from this "
              "key; zeros: chosen so that it is smooth");
        field("after", k.after, "the same toward the key after it");
    }
};

template <> struct FieldsOf<Track> {
    static constexpr std::string_view told_as = "[track](#track)";
    static void fields(auto& t, auto&& field)
    {
        field("parameter", t.parameter,
              "name of a number of the object, as transform.translation.z, or of the scene, as "
              "render.exposure",
              required);
        field("keys", t.keys, "ascending by frame; none: it is not animated any more");
        field("repeat", t.repeat,
              "what comes after the last key: it stays, all of it again, or the way back");
    }
};

} // namespace trivar
