// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace trivar {

// A Unit says what a number measures, and in which unit it is stored.
enum class Unit {
    none,
    metres,
    degrees,
    radians, // shown in degrees
    seconds,
    metres_per_second,
    frames_per_second,
    stops,
    share, // shown in percent
    times,
    turns, // whole ones
    sides, // of tiles
    pixels,
    at_frame
};

// A Counting says how the digest of a document counts a field. It exists because scenes were made
// before some fields existed, and their digests stay.
enum class Counting {
    always,
    named, // not counted at its default; else its name and its value
    // the same as `named`, but of a switch the name alone, of a list its entries without their
    // number and of a value that may be missing only the value
    marked,
    bare // not counted at its default; else its value alone
};

// A FileKind says how a file that a field names is read.
enum class FileKind { model, font, image, volume };

// A Rule holds what is known of a field besides its name and its help. Bounds are inclusive and
// hold for every component of a vector.
struct Rule {
    bool required = false; // must stand in JSON; else a missing field has its default
    // bounds of numbers; the defaults bound every coordinate and size of a scene
    double lo = -1e9, hi = 1e9;
    std::string_view choices{}; // of texts, separated by |; empty: any
    Counting counted = Counting::always;
    double rest = 0;          // the default of its numbers, where `counted` is not `always`
    std::string_view label{}; // what panels and the history call it; empty: its name in words
    Unit unit = Unit::none;
    std::string_view axes = "X|Y|Z|W";       // what the components of a vector are called
    std::string_view yes = "on", no = "off"; // what a switch says
    std::string_view zero{};                 // the word for 0 or an empty list; empty: no word
    bool fixed = false;                      // the field takes no keys
    // The greatest number per component that works. Some scenes were written with more: such
    // numbers are read, and evaluation adds a notice. 0: hi.
    std::array<int, 3> works_to{};
    bool inlined = false;         // names of parameters leave out the name of this field
    std::string_view in_copies{}; // its name where an object is copied; empty: the same
    bool object = false;          // it holds ids of objects; 0: none
    // The objects are to what names them: "painted on" them it is. Its shape depends on them.
    // Empty: it does not.
    std::string_view use{};
    std::optional<FileKind> file{}; // of a text: the path of a file, whose digest is the next field
    bool in_use = true;             // of a file: it is read at present
    bool digest = false;            // of a text: the digest of the file before it; empty: any
    std::string_view no_name{};     // why it names neither object nor file, though it looks so

    constexpr Rule called(std::string_view name) const { return with(&Rule::label, name); }
    constexpr Rule in(Unit of) const { return with(&Rule::unit, of); }
    constexpr Rule counts(Counting how) const { return with(&Rule::counted, how); }
    constexpr Rule resting_at(double value) const { return with(&Rule::rest, value); }
    constexpr Rule with_axes(std::string_view names) const { return with(&Rule::axes, names); }
    constexpr Rule says(std::string_view on, std::string_view off) const
    {
        return with(&Rule::yes, on).with(&Rule::no, off);
    }
    constexpr Rule zero_is(std::string_view words) const { return with(&Rule::zero, words); }
    constexpr Rule without_keys() const { return with(&Rule::fixed, true); }
    constexpr Rule as_its_own() const { return with(&Rule::inlined, true); }
    constexpr Rule copied_as(std::string_view name) const { return with(&Rule::in_copies, name); }
    constexpr Rule names_object(std::string_view words = {}) const
    {
        return with(&Rule::object, true).with(&Rule::use, words);
    }
    constexpr Rule names_file(FileKind kind, bool read = true) const
    {
        return with(&Rule::file, std::optional(kind)).with(&Rule::in_use, read);
    }
    constexpr Rule digest_of_file() const { return with(&Rule::digest, true); }
    constexpr Rule names_nothing(std::string_view why) const { return with(&Rule::no_name, why); }

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
constexpr Rule required_in_range(double lo, double hi)
{
    return {.required = true, .lo = lo, .hi = hi};
}
constexpr Rule in_range(double lo, double hi)
{
    return {.lo = lo, .hi = hi};
}
constexpr Rule works_in_range(double lo, std::array<int, 3> works_to, double hi)
{
    return {.lo = lo, .hi = hi, .works_to = works_to};
}
constexpr Rule later{.counted = Counting::named};
constexpr Rule later_in_range(double lo, double hi)
{
    return {.lo = lo, .hi = hi, .counted = Counting::named};
}
constexpr Rule positive{.lo = 1e-9};
constexpr Rule not_negative{.lo = 0};
constexpr Rule one_of(std::string_view choices)
{
    return {.choices = choices};
}

} // namespace trivar
