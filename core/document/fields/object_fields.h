// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/attachment_fields.h"
#include "core/document/fields/cutting_fields.h"
#include "core/document/fields/import_fields.h"
#include "core/document/fields/incising_fields.h"
#include "core/document/fields/lattice_fields.h"
#include "core/document/fields/line_fields.h"
#include "core/document/fields/placement_fields.h"
#include "core/document/fields/playing_fields.h"
#include "core/document/fields/primitive_fields.h"
#include "core/document/fields/refining_fields.h"
#include "core/document/fields/shading_fields.h"
#include "core/document/fields/shaping_fields.h"
#include "core/document/fields/simplex_sheet_fields.h"
#include "core/document/fields/simplifying_fields.h"
#include "core/document/fields/splitting_fields.h"
#include "core/document/fields/surfacing_fields.h"
#include "core/document/fields/tetrahedra_fields.h"
#include "core/document/fields/text_fields.h"
#include "core/document/fields/tiles_fields.h"
#include "core/document/fields/track_fields.h"
#include "core/document/fields/travel_fields.h"
#include "core/document/fields/unwrapping_fields.h"
#include "core/document/fields/view_fields.h"
#include "core/document/fields/voxel_fields.h"

// The fields of all that an object or a scene holds. Whoever walks through a whole object includes
// this: a value whose fields nobody listed would be passed over in silence. The digest of a
// document, the numbers that take keys, their names and units, copies and the titles of steps come
// from here.

namespace trivar {

template <> struct FieldsOf<GroupShape> {
    static void fields(auto&, auto&&) {}
};
template <> struct FieldsOf<RoundWay> {
    static void fields(auto& r, auto&& field)
    {
        field("level", r.level, "metres from the widest circle of that object, or from its origin",
              any_value.in(Unit::metres));
        field("normal", r.normal,
              "of the plane that cuts that object, in its own space; left out: none does",
              any_value.counts(Counting::marked).without_keys());
    }
};
template <> struct FieldsOf<PlacementStep> {
    static constexpr std::string_view copied_as = "[placement](#placement)";
    static void fields(auto& p, auto&& field)
    {
        field("sketch", p.sketch, "the stroke; none if it lies round an object",
              any_value.without_keys());
        field("parameters", p.parameters, "how it lies", any_value.as_its_own());
        field("onto", p.onto, "ids of its hosts: in a copy other copies, or objects of the scene",
              any_value.without_keys().names_object(lies_on_words));
        field("round", p.round, "about the only one of onto, in place of a stroke",
              any_value.counts(Counting::marked).as_its_own());
        field("attach", p.attach, "the hosts among onto that carry it, and where it lay on them",
              any_value.counts(Counting::marked).without_keys());
    }
};

// In the order in which the digest takes them; copies have them in another one.
template <> struct FieldsOf<Object> {
    static void shape(auto& o, auto&& field)
    {
        field("name", o.name, "its name, with a number if the name is taken", required);
        field("shape", o.source, "what it is made of");
        field("transform", o.transform, "its transform, in its group if that is copied, too");
    }
    static void material(auto& o, auto&& field)
    {
        field("material", o.surfacing, "one material over all of it; left out: its own");
    }
    static void state(auto& o, auto&& field)
    {
        field("parent", o.parent, "id of the group it is in; a copied one comes before it; 0: none",
              any_value.without_keys().names_object());
        field("hidden", o.hidden, "it is not in the picture");
        field("locked", o.locked, "it cannot be picked, moved or deleted by hand",
              any_value.counts(Counting::marked).without_keys());
    }
    static void steps(auto& o, auto&& field)
    {
        const bool goes = o.stroke || o.travel != Travel{}; // what lies nowhere has nowhere to go
        field("placement", o.stroke, "how it lies on a stroke");
        field("shaping", o.shaping, "what was done to its volume after that, step by step",
              any_value.counts(Counting::marked).called("Step"));
        field("travel", o.travel, "how it travels along its stroke",
              goes ? later : later.without_keys());
        field("playing", o.playing, "how an imported model moves by a clip of its file", later);
        field("refining", o.refining, "how finely its triangles are split",
              any_value.counts(Counting::marked));
        field("simplifying", o.simplifying, "how its triangles are reduced",
              any_value.counts(Counting::marked).without_keys());
        field("unwrapping", o.unwrapping, "how its texture coordinates are made",
              any_value.counts(Counting::marked).without_keys());
        field("shading", o.shading, "where it looks smooth and where it shows edges",
              any_value.counts(Counting::marked).without_keys());
        field("incising", o.incising, "where its skin is cut open",
              any_value.counts(Counting::marked));
    }
    static void layers(auto& o, auto&& field)
    {
        field("tiles", o.tiles, "how copies of it are painted on another object",
              any_value.counts(Counting::marked).copied_as("tiling"));
        field("cutting", o.cutting, "where it is cut in pieces",
              any_value.counts(Counting::marked));
        field("splitting", o.splitting, "what parts it, and how its halves are closed",
              any_value.counts(Counting::marked));
        field("line_drawing", o.line_drawing, "how it is drawn in lines",
              any_value.counts(Counting::marked));
        field("tracks", o.tracks, "its animated parameters with their keys", later.without_keys());
    }
    static void fields(auto& o, auto&& field)
    {
        shape(o, field);
        material(o, field);
        state(o, field);
        steps(o, field);
        layers(o, field);
    }
};

} // namespace trivar
