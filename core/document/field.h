// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/document/rule.h"

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
template <class T> inline constexpr bool is_ref = false;
template <class T> inline constexpr bool is_ref<Ref<T>> = true;
template <class T> inline constexpr bool is_choice = false; // one of several types
template <class... T> inline constexpr bool is_choice<std::variant<T...>> = true;

// The texts of an enumeration's values, in their order.
template <class E> constexpr std::array<std::string_view, 0> choice_names{};
// The same as a person says them, where that is not the text with blanks.
template <class E> constexpr std::array<std::string_view, 0> choice_words{};
// Whether it was a switch in older files: false and true are read as its first two values.
template <class E> constexpr bool was_switch = false;
template <>
inline constexpr std::array<std::string_view, 4> choice_words<Misses>{
    "membrane", "drop to the ground", "nearest point", "shrink"};
template <>
inline constexpr std::array<std::string_view, 6> choice_words<ColorBy>{
    "material", "stretch", "error", "UV angles", "UV areas", "UV checker"};
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
inline constexpr std::array<std::string_view, 4> choice_names<Filling>{"none", "wood", "flesh",
                                                                       "metal"};
template <>
inline constexpr std::array<std::string_view, 6> choice_names<ColorBy>{
    "material", "stretch", "error", "uv_angles", "uv_areas", "uv_checker"};

// The fields of values that live inside commands; nested in JSON as they are here.
template <class T> struct FieldsOf;

template <> struct FieldsOf<Transform> {
    static constexpr std::string_view
        told_as = "[transform](#transform-1)",
        about = "Scale first, then the turns about X, Y and Z, then the translation.";
    static void fields(auto& t, auto&& field)
    {
        field("translation", t.translation, "where it is in its group or the scene, metres",
              any_value.called("Position").in(Unit::metres));
        field("rotation_deg", t.rotation_deg, "about X, then Y, then Z, in degrees",
              any_value.called("Rotation").in(Unit::degrees));
        field("scale", t.scale, "along X, Y and Z; negative mirrors, 0 is refused");
    }
};
template <> struct FieldsOf<Camera> {
    static constexpr std::string_view
        told_as = "[camera](#camera)",
        about = "A view of the scene. Pixels count from the top left corner of the picture.";
    static void fields(auto& c, auto&& field)
    {
        field("eye", c.eye, "where the camera is, metres", required.called("Eye").in(Unit::metres));
        field("target", c.target, "the point it looks at, metres",
              required.called("Target").in(Unit::metres));
        field("up", c.up, "the direction that is up in the picture");
        field("perspective", c.perspective, "false: orthographic");
        field("fov_y", c.fov_y, "full vertical angle in radians, perspective only",
              in_range(1e-3, 3.1).called("Field of view").in(Unit::radians));
        field("height_world", c.height_world, "height of the picture in metres, orthographic only",
              positive.in(Unit::metres));
        field("size_px", c.size_px, "width and height of the picture in pixels",
              in_range(1, 65536).without_keys());
    }
};

// Values whose fields are listed by a specialisation of FieldsOf.
template <class T>
concept Nested = requires(T& value)
{
    FieldsOf<std::remove_const_t<T>>::fields(value, [](auto&&...) {});
};

// Gives the fields of a value to a list of fields in which they stand without a name of their own.
template <class T> void spread(T& value, auto&& field)
{
    if constexpr (requires { field.spread(value); })
        field.spread(value);
    else
        FieldsOf<std::remove_const_t<T>>::fields(value, field);
}

// Calls field(name, value, help, rule) for each field of a command or of a nested value.
template <class T> void each_field(T& value, auto&& field)
{
    if constexpr (Nested<T>)
        FieldsOf<std::remove_const_t<T>>::fields(value, field);
    else
        T::fields(value, field);
}

} // namespace trivar
