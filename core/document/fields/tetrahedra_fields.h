// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/shaping_fields.h"
#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

template <> struct FieldsOf<TetrahedraPull> {
    static constexpr std::string_view told_as = "[pull](#pull)";
    static void fields(auto& p, auto&& field)
    {
        field("layer", p.layer,
              "whose control points move; 0: of the domain, 1 and more: of a refinement",
              in_range(0, 1000).called("Layer").without_keys());
        field("at", p.at, "the middle of the ball, in the volume before it was deformed",
              required.called("Middle").in(Unit::metres));
        field("also", p.also, "middles of more balls of the same radius", later.without_keys());
        field("radius", p.radius, "of the ball, metres",
              positive.called("Radius").in(Unit::metres));
        field("by", p.by, "metres by which its middle moves",
              any_value.called("Move").in(Unit::metres));
        field("rotation_deg", p.rotation_deg, "degrees about X, Y and Z, about its middle",
              in_range(-3600, 3600).called("Turn").in(Unit::degrees));
        field("factors", p.factors, "by which it grows along X, Y and Z, about its middle",
              later_in_range(-1000, 1000).resting_at(1).called("Scale").in(Unit::times));
        field("decay", p.decay, "how it fades from the middle to the rim",
              any_value.called("Fading"));
        field("guard", p.guard, "stops it before the volume would fold", any_value.called("Guard"));
    }
};
template <> struct FieldsOf<TetrahedraCrease> {
    static constexpr std::string_view told_as = "[crease](#crease)";
    static void fields(auto& c, auto&& field)
    {
        field("places", c.places, "points on faces between tetrahedra", required.without_keys());
        field("radius", c.radius,
              "metres from one of these places within which the middle of a face must be",
              positive.called("Radius").in(Unit::metres).without_keys());
        field("depth", c.depth,
              "number of derivatives that are lost there; the degree of the volume: it is cut; 0: "
              "earlier creases and cuts are taken away",
              in_range(0, 3).called("Depth").without_keys());
        field("seam", c.seam,
              "whether what is cut stays in one piece all the same, with slopes that may jump",
              later.called("Seam").without_keys());
    }
};
template <> struct FieldsOf<TetrahedraRefinement> {
    static constexpr std::string_view told_as = "[refinement](#refinement)";
    static void fields(auto& r, auto&& field)
    {
        field("places", r.places, "points along a stroke", required.without_keys());
        field("radius", r.radius, "metres round each of them that are refined",
              positive.called("Radius").in(Unit::metres).without_keys());
        field("edge", r.edge, "length of the edges of the small tetrahedra, metres",
              positive.called("Edge").in(Unit::metres).without_keys());
    }
};
template <> struct FieldsOf<TetrahedraCloud> {
    static constexpr std::string_view told_as = "[cloud](#cloud)";
    static void fields(auto& c, auto&& field)
    {
        field("at", c.at, "where a vertex of the domain is, before it was deformed",
              required.called("Vertex").in(Unit::metres).without_keys());
        field("knot", c.knot, "which knot of its cloud, from 1 to the degree; 0: all",
              in_range(0, 3).called("Knot").without_keys());
        field("by", c.by, "metres from where the knot would be",
              any_value.called("Move").in(Unit::metres));
        field("factor", c.factor, "distance from the vertex, in shares of what it would be",
              in_range(0, 100).called("Distance").in(Unit::share));
    }
};
template <> struct FieldsOf<TetrahedraEdit> {
    static constexpr std::string_view told_as = "[edit](#edit)";
    static void fields(auto& e, auto&& field)
    {
        field("pull", e.pull, "control points in a ball moved and turned");
        field("warp", e.warp, "the box round the domain twisted, bent, tapered, sheared or bulged");
        field("crease", e.crease, "less continuity across some faces, or none");
        field("refinement", e.refinement, "a layer of smaller tetrahedra, in the same shape");
        field("cloud", e.cloud, "knots of a vertex moved by hand", later);
    }
};
template <> struct FieldsOf<TetrahedraFunction> {
    static constexpr std::string_view told_as = "[function](#function)";
    static void fields(auto& f, auto&& field)
    {
        field("at", f.at, "near the resting place of its control point",
              required.called("Place").in(Unit::metres));
        field("share", f.share, "of its greatest value, on the surface that is shown",
              in_range(0.01, 0.99).called("Share").in(Unit::share));
    }
};
template <> struct FieldsOf<TetrahedraShape> {
    static constexpr std::string_view told_as = "values of [add_tetrahedra](#add_tetrahedra)",
                                      copied = "tetrahedra";
    static void fields(auto& s, auto&& field)
    {
        field("size", s.size, "size of the box along X, Y and Z, metres; its middle is its origin",
              positive.in(Unit::metres));
        field("boxes", s.boxes, "along X, Y and Z, of six tetrahedra each",
              in_range(1, 100).called("Boxes").without_keys());
        field("degree", s.degree, "of the splines: 1 linear, 2 quadratic, 3 cubic",
              in_range(1, 3).called("Degree").without_keys());
        field("spread", s.spread,
              "distance of knots from their vertex, as a share of its shortest edge",
              in_range(0.01, 0.3).called("Spread").in(Unit::share).without_keys());
        field("vertices", s.vertices, "of tetrahedra that fill no box", any_value.without_keys());
        field("cells", s.cells, "four numbers of vertices per tetrahedron; none: the box",
              in_range(0, 1e9).without_keys());
        field("displaced", s.displaced,
              "what a lattice did before it became these tetrahedra: displacements at 4, 10 or 20 "
              "nodes of each of them, for degrees 1, 2 and 3",
              later.without_keys());
        field("deviation", s.deviation,
              "greatest distance from what the lattice did, at samples, metres",
              later.without_keys());
        field("edits", s.edits, "what was done to it, in order");
        field("functions", s.functions, "basis functions that are shown as surfaces");
    }
};

} // namespace trivar
