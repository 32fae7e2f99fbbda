// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

inline constexpr std::string_view lies_on_words = "laid on"; // what a host is to what lies on it

// The ranges that a panel offers and a log may hold; place() may still refuse a combination.
template <> struct FieldsOf<PlacementParameters> {
    static constexpr std::string_view told_as = "[parameters](#parameters)",
                                      about = "How an object lies along its stroke.";
    static void fields(auto& p, auto&& field)
    {
        field("width", p.width, "size across the stroke, metres; 0: in proportion to the model",
              not_negative.in(Unit::metres).zero_is("automatic"));
        field("height", p.height,
              "size away from the surface, metres; 0: in proportion to the model",
              not_negative.in(Unit::metres).zero_is("automatic"));
        field("grid", p.grid, "control points along, across and above the stroke",
              works_in_range(2, {most_along_or_across, most_along_or_across, most_layers}, 1024)
                  .called("Density")
                  .with_axes("U|V|W"));
        field("orders", p.orders,
              "order of the volume along, across and above the stroke: 3 is quadratic, 4 is cubic",
              in_range(2, 6).called("Order").with_axes("U|V|W"));
        field("offset", p.offset,
              "0: the volume rises toward the camera, 1: it rises along the normals of the surface",
              in_range(0, 1));
        field("springs", p.springs,
              "springs hold the model over gaps; without them it drops into gaps",
              any_value.called("Gaps").says("bridged", "not bridged"));
        field("stiffness", p.stiffness,
              "stiffness of the springs: a span of stiffness x length sags by a tenth of the gap",
              in_range(1e-3, 1e3));
        field("bending", p.bending, "resistance to bending, relative to stiffness",
              in_range(0, 10));
        field("neighborhood", p.neighborhood,
              "number of grid steps round a rough node that may leave the surface",
              works_in_range(0, {most_along_or_across}, 1024).called("Reach"));
        field("roughness_deg", p.roughness_deg,
              "angle between neighbouring faces above which a node is rough, degrees",
              in_range(1, 90).in(Unit::degrees));
        field("free_ends", p.free_ends,
              "the first and the last row of nodes may leave the surface, too",
              any_value.called("Ends").says("free", "fixed"));
        field("misses", p.misses, "what happens to a node whose ray hits nothing");
        field("skip_back_faces", p.skip_back_faces, "rays pass through faces seen from behind",
              any_value.called("Back faces").says("let through", "hit"));
        field("start", p.start, "where along the stroke the model begins", in_range(0, 1));
        field("fill", p.fill,
              "share of the stroke the model occupies; start + fill cannot exceed 1",
              in_range(1e-3, 1));
        field("lift_tolerance", p.lift_tolerance,
              "how deep the scene may stay in the volume, as a fraction of the height",
              in_range(0, 1).called("Sinking"));
        field("clearance", p.clearance, "metres kept between scene and contact surface",
              not_negative.in(Unit::metres));
        field("reverse", p.reverse, "the model looks toward the start of the stroke",
              any_value.called("Direction").says("toward the start", "toward the end"));
        field("roll_deg", p.roll_deg, "quarter turns about its length: 0, 90, 180 or 270",
              in_range(0, 270).in(Unit::degrees));
        field("width_profile", p.width_profile,
              "how the width changes along the stroke: control points of a curve, [share of the "
              "length, factor] each; none: it is even",
              later_in_range(0, 20).zero_is("even"));
        field("height_profile", p.height_profile, "how the height changes along the stroke",
              later_in_range(0, 20).zero_is("even"));
        field("height_across", p.height_across,
              "how the height changes across the stroke, from its right to its left: control "
              "points as along the stroke; both factors count",
              later_in_range(0, 20).zero_is("even"));
        field("height_map", p.height_map,
              "how the height changes over the whole strip: control points of a surface, 2 to 32 "
              "rows along the stroke with 2 to 32 factors each, from right to left; multiplied "
              "with the other two; none: it is even",
              later_in_range(0, 20).zero_is("even"));
        field("rise_profile", p.rise_profile,
              "how the height is distributed from the bottom to the top: control points of an "
              "ascending curve, [share of the model's height, share of the volume's]; none: evenly",
              later_in_range(0, 1).called("Height distribution").zero_is("even"));
        field("contact_level", p.contact_level,
              "the level of the volume that lies on the scene: 0 its bottom, 1 its top",
              later_in_range(0, 1));
        field("along", p.along,
              "the axis of the model that runs along the stroke; turned before the roll",
              later.called("Axis along"));
        field("sharp", p.sharp,
              "whether it follows sharp edges of the scene, by control points that are added there",
              later.called("Edges").says("sharp", "rounded"));
        field("on_ground", p.on_ground, "whether it lies on the ground, too, the plane Z 0",
              later.called("Ground").says("lies on it", "passed over"));
        field("bridge_jumps", p.bridge_jumps,
              "what it does where the stroke passes an edge and meets what is far behind it: it "
              "stays on the surface before the edge, or goes down there",
              later.called("Depth jumps").says("bridged", "followed"));
    }
};

template <> struct FieldsOf<Sketch> {
    static constexpr std::string_view told_as = "[sketch](#sketch)",
                                      about = "A stroke and the view it was drawn in.";
    static void fields(auto& s, auto&& field)
    {
        field("camera", s.camera, "the view the stroke was drawn in", required.without_keys());
        field("samples", s.samples, "the stroke, [x px, y px, seconds, pressure] each",
              required.without_keys());
    }
};

} // namespace trivar
