// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<Decay>{"gaussian", "hat", "box",
                                                                     "smooth"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<VolumeAxis>{"along", "across", "up"};

template <> struct FieldsOf<Press> {
    static constexpr std::string_view told_as = "values of [press](#press)";
    static void fields(auto& p, auto&& field)
    {
        field("decay", p.decay,
              "how the press fades from the middle to the rim of the ball: as a bell, linearly, "
              "not at all, or smoothly");
        field("radius", p.radius, "radius of the ball, metres", positive.in(Unit::metres));
        field("samples", p.samples,
              "where the ball presses and how far, [u, v, w, metres] each; u, v, w are the "
              "volume's, 0 to 1; negative metres pull",
              required);
        field("mirror", p.mirror, "mirrors the press to the other side of the middle, at 1 - v");
        field("guard", p.guard, "stops it before the volume would fold");
        field("into_scene", p.into_scene, "the model may be pulled into the surface it lies on");
    }
};
template <> struct FieldsOf<PointShift> {
    static constexpr std::string_view told_as = "values of [move_points](#move_points)";
    static void fields(auto& s, auto&& field)
    {
        field("points", s.points,
              "numbers of the control points along, across and up, from 0; the directions along, "
              "across and up are those at the first point",
              required.without_keys());
        field("by", s.by, "metres along, across and up", required.called("Move").in(Unit::metres));
        field("mirror", s.mirror, "points on the other side of the middle go the other way across");
        field("guard", s.guard, "stops the motion before the volume would fold");
        field("of", s.of,
              "numbers of control points of the volume along, across and up, without which the "
              "step is skipped; zeros: any",
              later.without_keys());
        field("weights", s.weights,
              "one for each of the points, 0 to 1: its share of the motion; none: all of it",
              later_in_range(0, 1).without_keys());
        field("rotation_deg", s.rotation_deg,
              "degrees about along, across and up, about the middle of the points with weight 1",
              later_in_range(-3600, 3600).called("Turn").in(Unit::degrees));
        field("factors", s.factors, "factors of the distance from that middle",
              later_in_range(-1000, 1000).resting_at(1).called("Scale").in(Unit::times));
        field("mirror_along", s.mirror_along,
              "points on the other side along go the other way, too", later);
        field("mirror_up", s.mirror_up, "points on the other side up go the other way, too", later);
    }
};
template <> struct FieldsOf<KnotInsertion> {
    static constexpr std::string_view told_as = "values of [insert_knots](#insert_knots)";
    static void fields(auto& k, auto&& field)
    {
        field("along", k.along,
              "where along the stroke, between 0 and 1; each adds a control point");
        field("across", k.across, "the same across the stroke");
        field("up", k.up, "the same up from the scene");
    }
};
template <> struct FieldsOf<Coarsening> {
    static constexpr std::string_view told_as = "values of [coarsen_volume](#coarsen_volume)";
    static void fields(auto& c, auto&& field)
    {
        field("axis", c.axis, "along the stroke, across it or up from the scene");
        field("count", c.count, "number of control points that remain along it", in_range(2, 1024));
    }
};
template <> struct FieldsOf<Mending> {
    static constexpr std::string_view told_as = "nothing inside: `{}`";
    static void fields(auto&, auto&&) {}
};
template <> struct FieldsOf<VolumePart> {
    static constexpr std::string_view told_as = "[part](#part)",
                                      about = "A box in a volume's own u, v and w.";
    static void fields(auto& b, auto&& field)
    {
        field("lo", b.lo, "u, v and w of its lower corner, 0 to 1", required);
        field("hi", b.hi, "u, v and w of its upper corner, above lo", required);
    }
};
template <> struct FieldsOf<FoldAllowance> {
    static constexpr std::string_view told_as = "values of [allow_folds](#allow_folds)";
    static void fields(auto& a, auto&& field)
    {
        field("boxes", a.boxes,
              "parts of the volume in u, v and w, in addition to earlier ones; none: folds are "
              "allowed nowhere");
    }
};
template <> struct FieldsOf<Warp> {
    static constexpr std::string_view told_as = "values of [warp_volume](#warp_volume)";
    static void fields(auto& w, auto&& field)
    {
        field("axis", w.axis, "the axis of the box that it goes along: X, Y or Z",
              any_value.without_keys());
        field("fixed", w.fixed,
              "where along the axis twist and bend change nothing; 0: at the near end",
              in_range(0, 1).called("Fixed at").in(Unit::share));
        field("twist_deg", w.twist_deg, "degrees from one end to the other, about the axis",
              in_range(-3600, 3600).in(Unit::degrees));
        field("bend_deg", w.bend_deg, "degrees that the axis turns from one end to the other",
              in_range(-720, 720).in(Unit::degrees));
        field("toward_deg", w.toward_deg,
              "the side to which it is bent and sheared, degrees about the axis",
              in_range(-360, 360).called("Toward").in(Unit::degrees));
        field("taper", w.taper, "the far end is 1 + taper times as wide",
              in_range(-1, 100).in(Unit::share));
        field("shear", w.shear, "how far the far end goes to the side, in lengths of the box",
              in_range(-100, 100).in(Unit::share));
        field("bulge", w.bulge, "the middle is 1 + bulge times as wide",
              in_range(-1, 100).in(Unit::share));
        field("guard", w.guard, "stops it before the volume would fold");
    }
};
template <> struct FieldsOf<VolumeEdit> {
    static constexpr std::string_view told_as = "[step](#step)",
                                      about = "What was done to a volume; one of them.";
    static void fields(auto& e, auto&& field)
    {
        field("press", e.press, "a ball pressed into it");
        field("shift", e.shift, "control points moved");
        field("insertion", e.insertion, "control points added, in the same shape");
        field("coarsening", e.coarsening, "fewer control points");
        field("mending", e.mending, "the smallest change after which nothing folds");
        field("allowance", e.allowance, "where folds are allowed from then on", later);
        field("warp", e.warp, "a box twisted, bent, tapered, sheared or bulged", later);
    }
};

} // namespace trivar
