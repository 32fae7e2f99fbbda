// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<AttachedHost> {
    static constexpr std::string_view told_as = "[host](#host)",
                                      about = "An object that carries what lies on it.";
    static void fields(auto& h, auto&& field)
    {
        field("object", h.object, "its id, one of onto", required.names_object());
        field("x", h.x, "its own X axis when the stroke was drawn");
        field("y", h.y, "its own Y axis then");
        field("z", h.z, "its own Z axis then");
        field("origin", h.origin, "its own origin then, metres", any_value.in(Unit::metres));
        field("touched", h.touched,
              "whether the strip lies on it; if not, it counts only while it does not move "
              "relative to the objects that the strip lies on");
    }
};

template <> struct FieldsOf<AttachedSample> {
    static constexpr std::string_view told_as = "[anchor](#anchor)",
                                      about = "Where a sample of a stroke met its host.";
    static void fields(auto& s, auto&& field)
    {
        field("host", s.host, "which of the hosts the sample met, from 0; -1: none",
              any_value.names_nothing("a place in a list"));
        field("mesh", s.mesh, "which of its meshes, from 0",
              any_value.names_nothing("a place in a list"));
        field("member", s.member, "which of it and its followers, from 0",
              any_value.names_nothing("a place in a list"));
        field("rest", s.rest, "position on that mesh, before a clip or a volume moves it");
        field("drawn", s.drawn, "position in the host's own space when the stroke was drawn");
        field("normal", s.normal, "unit normal of the face there, in that space");
    }
};

template <> struct FieldsOf<Attachment> {
    static constexpr std::string_view told_as = "[attachment](#attachment)",
                                      about = "What a stroke belongs to.";
    static void fields(auto& a, auto&& field)
    {
        field("hosts", a.hosts, "its hosts, in any order", required);
        field("samples", a.samples,
              "where each sample of the stroke met a host; none: all belong to the first");
    }
};

} // namespace trivar
