// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"
#include "core/document/fields/flap_fields.h"
#include "core/document/fields/surfacing_fields.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 3> choice_names<IncisionProfile::Shape>{
    "lens", "even", "custom"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<Incision::Floor>{"v", "u", "through"};
template <>
inline constexpr std::array<std::string_view, 3> choice_words<Incision::Floor>{
    "sharp", "flat", "none: through the body"};
template <>
inline constexpr std::array<std::string_view, 2> choice_names<Incision::Piece>{"kept", "left_out"};

template <> struct FieldsOf<SurfacePoint> {
    static constexpr std::string_view told_as = "[surface point](#surface-point)",
                                      about = "A point of the stroke of an incision.";
    static void fields(auto& s, auto&& field)
    {
        field("p", s.p, "a point of the object's model at rest, metres", required.in(Unit::metres));
        field("normal", s.normal, "the normal there", required);
    }
};
template <> struct FieldsOf<IncisionProfile> {
    static constexpr std::string_view told_as = "[profile](#profile)",
                                      about = "How a number goes along an incision.";
    static void fields(auto& p, auto&& field)
    {
        field("shape", p.shape,
              "lens: most in the middle; even: the same but near the ends; custom: by the points");
        field("points", p.points,
              "of a custom profile, each [share of the length, share of the greatest value], "
              "lengths ascending, with straight lines between");
    }
};
template <> struct FieldsOf<NamedIncision> {
    static constexpr std::string_view told_as = "values of [incise](#incise)";
    // Lists all fields but the stroke.
    static void numbers(auto& i, auto&& field)
    {
        field("name", i.name, "what it is called; empty: by its number");
        field("hidden", i.hidden, "the skin is as if it were not there",
              any_value.called("Incision").says("off", "on"));
        field("depth", i.cut.depth, "where it is deepest, metres on the model",
              positive.called("Depth").in(Unit::metres));
        field("depth_profile", i.cut.depth_profile, "how the depth goes along it",
              any_value.called("Depth profile").without_keys());
        field(
            "floor", i.cut.floor,
            "v: its walls meet below; u: a flat floor joins them; through: it goes to the skin on "
            "the other side, which opens too, or where that fails has a sharp floor at its depth",
            any_value.called("Floor").without_keys());
        field("floor_width", i.cut.floor_width, "of a flat floor, as a share of that at the skin",
              in_range(0, 1).called("Floor width").in(Unit::share));
        field("piece", i.cut.piece,
              "of a loop through the body, which ends where it began: whether the smaller part is "
              "kept or left out, so that there is a hole",
              later.called("Piece").without_keys());
        field("lean_deg", i.cut.lean_deg,
              "angle by which its walls lean, on their way down to the left of the stroke, degrees",
              later_in_range(-75, 75).called("Lean").in(Unit::degrees));
        field("bevel", i.cut.bevel,
              "by which its rim is set back beyond the width when it is quite open, and down to "
              "which depth; metres on the model",
              later_in_range(0, 1e9).called("Bevel").in(Unit::metres).zero_is("none"));
        field("roundness", i.cut.roundness, "of the bevel: 0 is flat, 1 a quarter of a circle",
              later_in_range(0, 1).called("Roundness").in(Unit::share));
        field("width", i.cut.width,
              "of the gap where it is widest, when it is quite open; metres on the model",
              positive.called("Width").in(Unit::metres));
        field("opening_profile", i.cut.opening_profile, "how the width goes along it",
              any_value.called("Opening profile"));
        field("reach", i.cut.reach,
              "how far beside it the skin gives way, metres on the model; 0: three widths",
              not_negative.called("Reach").in(Unit::metres).zero_is("three widths"));
        field("opening", i.opening.share, "share of the width: 0 is shut, 1 quite open",
              in_range(0, 1).called("Opening").in(Unit::share));
        field("from", i.opening.from,
              "share of the length up to which it is shut: behind the blade",
              in_range(0, 1).called("Shut until").in(Unit::share));
        field("to", i.opening.to, "share of the length from which on it is shut: before the blade",
              in_range(0, 1).called("Open until").in(Unit::share));
        field("blade", i.blade,
              "id of an object that opens it: up to the place nearest to the object's origin, and "
              "no further than `to`; 0: none does",
              later_in_range(0, 1e9).called("Blade").zero_is("none").without_keys().names_object(
                  "opened by"));
    }
    static void fields(auto& i, auto&& field)
    {
        field("stroke", i.cut.stroke, "the points that it goes through, two at least",
              required.without_keys());
        numbers(i, field);
    }
};
template <> struct FieldsOf<IncisionLayer> {
    static constexpr std::string_view told_as = "[incision layer](#incision-layer)",
                                      about = "What the walls of incisions show down to a depth.";
    static void fields(auto& l, auto&& field)
    {
        field("name", l.name, "what it is called");
        field("depth", l.depth, "of its end, metres on the model; the last one goes to the floor",
              not_negative.called("Depth").in(Unit::metres).without_keys());
        spread(l.look, field);
    }
};
template <> struct FieldsOf<Incising> {
    static constexpr std::string_view told_as = "[incisions](#incisions)",
                                      about = "Where the skin of a copied object is cut open.";
    static void fields(auto& i, auto&& field)
    {
        field("cuts", i.cuts, "its incisions, the first one first", required);
        layers(i, field);
        field("flaps", i.flaps, "the flaps between incisions that are bent outward", later);
    }
    static void layers(auto& i, auto&& field)
    {
        field("layers", i.layers,
              "what the walls show, from the skin down; none: they look as the skin above");
        field("rows", i.rows, "of faces from the skin down to the deepest floor",
              in_range(1, 64).called("Rows").without_keys());
    }
};

} // namespace trivar
