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
template <class T> inline constexpr bool is_ref = false;
template <class T> inline constexpr bool is_ref<Ref<T>> = true;
template <class T> inline constexpr bool is_choice = false; // one of several types
template <class... T> inline constexpr bool is_choice<std::variant<T...>> = true;

// What a number measures, in what it is stored in.
enum class Unit {
    none,
    metres,
    degrees,
    radians, // shown in degrees
    seconds,
    metres_per_second,
    frames_per_second,
    stops,
    times,
    at_frame
};

// How the digest of a document counts a field. Scenes were made before some fields existed, and
// their digests stay.
enum class Counted {
    always,
    named,  // not where it has its default; else its name and its value
    marked, // the same, but of a switch the name alone, of a list its entries without their number
            // and of a value that may be missing only the value
    bare    // not where it has its default; else its value alone
};

// What is known of a field beside its name and its help. Bounds are inclusive and hold for every
// component of a vector.
struct Rule {
    bool required = false;      // in JSON; else what is left out has its default
    double lo = -1e9, hi = 1e9; // of numbers; no coordinate or size of a scene is beyond
    std::string_view choices{}; // of texts, separated by |; empty: any
    Counted counted = Counted::always;
    std::string_view label{}; // what panels and the history call it; empty: its name in words
    Unit unit = Unit::none;
    std::string_view axes = "X|Y|Z|W";       // what the components of a vector are called
    std::string_view yes = "on", no = "off"; // what a switch says
    std::string_view zero{};                 // what 0 or an empty list means; empty: just that
    bool fixed = false;                      // it takes no keys
    // The most of each number that works, where scenes were written with more: that is read, and
    // when it is evaluated it is said. 0: hi.
    std::array<int, 3> works_to{};
    bool inlined = false; // names of parameters leave out this field's own

    constexpr Rule called(std::string_view name) const { return with(&Rule::label, name); }
    constexpr Rule in(Unit of) const { return with(&Rule::unit, of); }
    constexpr Rule counts(Counted how) const { return with(&Rule::counted, how); }
    constexpr Rule with_axes(std::string_view names) const { return with(&Rule::axes, names); }
    constexpr Rule says(std::string_view on, std::string_view off) const
    {
        return with(&Rule::yes, on).with(&Rule::no, off);
    }
    constexpr Rule zero_is(std::string_view words) const { return with(&Rule::zero, words); }
    constexpr Rule without_keys() const { return with(&Rule::fixed, true); }
    constexpr Rule as_its_own() const { return with(&Rule::inlined, true); }

private:
    template <class T> constexpr Rule with(T Rule::*member, T value) const
    {
        Rule changed = *this;
        changed.*member = value;
        return changed;
    }
};
constexpr Rule any_value{};
constexpr Rule required{.required = true};
constexpr Rule required_between(double lo, double hi)
{
    return {.required = true, .lo = lo, .hi = hi};
}
constexpr Rule between(double lo, double hi)
{
    return {.lo = lo, .hi = hi};
}
constexpr Rule works_between(double lo, std::array<int, 3> works_to, double hi)
{
    return {.lo = lo, .hi = hi, .works_to = works_to};
}
constexpr Rule later{.counted = Counted::named};
constexpr Rule later_between(double lo, double hi)
{
    return {.lo = lo, .hi = hi, .counted = Counted::named};
}
constexpr Rule positive{.lo = 1e-9};
constexpr Rule not_negative{.lo = 0};
constexpr Rule one_of(std::string_view choices)
{
    return {.choices = choices};
}

// The texts of an enumeration's values, in their order.
template <class E> constexpr std::array<std::string_view, 0> choice_names{};
// The same as a person says them, where that is not the text with blanks.
template <class E> constexpr std::array<std::string_view, 0> choice_words{};
template <>
inline constexpr std::array<std::string_view, 4> choice_words<Misses>{
    "membrane", "drop to the ground", "nearest point", "shrink"};
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
    static constexpr std::string_view told_as = "[transform](#transform-1)";
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
    static constexpr std::string_view told_as = "[camera](#camera)";
    static void fields(auto& c, auto&& field)
    {
        field("eye", c.eye, "where the camera is, metres",
              required.called("From").in(Unit::metres));
        field("target", c.target, "the point it looks at, metres",
              required.called("To").in(Unit::metres));
        field("up", c.up, "the direction that is up in the picture");
        field("perspective", c.perspective, "false: orthographic");
        field("fov_y", c.fov_y, "full vertical angle in radians, perspective only",
              between(1e-3, 3.1).called("Angle").in(Unit::radians));
        field("height_world", c.height_world, "height of the picture in metres, orthographic only",
              positive.in(Unit::metres));
        field("size_px", c.size_px, "width and height of the picture in pixels",
              between(1, 65536).without_keys());
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
