// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <array>
#include <string_view>
#include <type_traits>

// A command is a struct of values with one list of its fields,
//
//   static void fields(auto& c, auto&& field) { field("width", c.width, "what it means", rule); }
//
// and JSON both ways, the checks of ranges, docs/commands.md, the default panel and the fuzzer all
// come from that list: each is a generic lambda
//
//   [&](std::string_view name, auto& value, std::string_view help, Rule rule = {}) { ... }

namespace trivar {

template <class T> inline constexpr bool is_list = false;
template <class T> inline constexpr bool is_list<std::vector<T>> = true;
template <class T> inline constexpr bool is_optional = false;
template <class T> inline constexpr bool is_optional<std::optional<T>> = true;

// What a field accepts. Bounds are inclusive and hold for every component of a vector.
struct Rule {
    bool required = false;      // in JSON; else what is left out has its default
    double lo = -1e9, hi = 1e9; // of numbers; no coordinate or size of a scene is beyond
    std::string_view choices{}; // of texts, separated by |; empty: any
    bool later = false;         // there were scenes without it, whose digests stay: no part of one
                                // where it is zero
};
constexpr Rule required{.required = true};
constexpr Rule required_between(double lo, double hi)
{
    return {.required = true, .lo = lo, .hi = hi};
}
constexpr Rule between(double lo, double hi)
{
    return {.lo = lo, .hi = hi};
}
constexpr Rule later{.later = true};
constexpr Rule later_between(double lo, double hi)
{
    return {.lo = lo, .hi = hi, .later = true};
}
constexpr Rule positive{.lo = 1e-9};
constexpr Rule not_negative{.lo = 0};
constexpr Rule one_of(std::string_view choices)
{
    return {.choices = choices};
}

// The texts of an enumeration's values, in their order.
template <class E> constexpr std::array<std::string_view, 0> choice_names{};
template <> inline constexpr std::array<std::string_view, 3> choice_names<UpAxis>{"auto", "y", "z"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<Misses>{"membrane", "ground",
                                                                      "nearest", "shrink"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<LengthAxis>{"x", "y", "z"};
template <>
inline constexpr std::array<std::string_view, 5> choice_names<Ends>{"stay", "hide", "run_on",
                                                                    "loop", "back_and_forth"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<Solid>{"none", "wood", "flesh"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<ColorBy>{"material", "stretch",
                                                                       "error"};

// The fields of values that live inside commands; nested in JSON as they are here.
template <class T> struct FieldsOf;

template <> struct FieldsOf<Transform> {
    static void fields(auto& t, auto&& field)
    {
        field("translation", t.translation, "where it is in its group or the scene, metres");
        field("rotation_deg", t.rotation_deg, "about X, then Y, then Z, in degrees");
        field("scale", t.scale, "along X, Y and Z; negative mirrors, 0 is refused");
    }
};
template <> struct FieldsOf<Camera> {
    static void fields(auto& c, auto&& field)
    {
        field("eye", c.eye, "where the camera is, metres", required);
        field("target", c.target, "the point it looks at, metres", required);
        field("up", c.up, "the direction that is up in the picture");
        field("perspective", c.perspective, "false: orthographic");
        field("fov_y", c.fov_y, "full vertical angle in radians, perspective only",
              between(1e-3, 3.1));
        field("height_world", c.height_world, "height of the picture in metres, orthographic only",
              positive);
        field("size_px", c.size_px, "width and height of the picture in pixels", between(1, 65536));
    }
};

// Values whose fields are listed by a specialisation of FieldsOf.
template <class T>
concept Nested = requires(T& value)
{
    FieldsOf<std::remove_const_t<T>>::fields(value, [](auto&&...) {});
};

// Calls field(name, value, help, rule) for each field of a command or of a nested value.
template <class T> void each_field(T& value, auto&& field)
{
    if constexpr (Nested<T>)
        FieldsOf<std::remove_const_t<T>>::fields(value, field);
    else
        T::fields(value, field);
}

} // namespace trivar
