// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<RenderSettings> {
    static void fields(auto& s, auto&& field)
    {
        field("look", s.look, "light and background", one_of("studio|clay|dark|paper|black"));
        field("exposure", s.exposure, "brightness, in stops", in_range(-20, 20).in(Unit::stops));
        field("sun_azimuth", s.sun_azimuth, "direction of the sun round Z, 0 along +X, in radians",
              in_range(-100, 100).called("Sun direction").in(Unit::radians));
        field("sun_elevation", s.sun_elevation,
              "how high the sun stands above the horizon, in radians",
              in_range(-1.6, 1.6).called("Sun elevation").in(Unit::radians));
        field("shadows", s.shadows, "the sun casts shadows", any_value.called("Sun shadows"));
        field("ambient_occlusion", s.ambient_occlusion, "darkens corners and creases",
              any_value.called("Ambient occlusion"));
        field("wire", s.wire, "draws the edges of faces over the surfaces", later.called("Edges"));
        field("color_by", s.color_by,
              "what colours show: materials, the stretch of placed objects, the error of their "
              "triangles, how UVs change angles or areas, or a checkered texture",
              later.called("Colour by"));
        field("volumes", s.volumes,
              "shows the lattices of placed objects, and the ball if the last edit was a press",
              later.called("Lattices").says("shown", "not shown"));
        field("captions", s.captions,
              "shows the number of triangles and the certified error under refined objects",
              later.called("Captions").says("shown", "not shown"));
        field("ground", s.ground, "a ground under the scene that catches shadows",
              any_value.called("Ground shadow"));
    }
};

template <> struct FieldsOf<Time> {
    static void fields(auto& t, auto&& field)
    {
        field("first_frame", t.first_frame, "the first frame that is played",
              in_range(-999999, 999999));
        field("last_frame", t.last_frame, "the last frame that is played",
              in_range(-999999, 999999));
        field("frames_per_second", t.frames_per_second, "frames shown per second",
              in_range(0.1, 1000).called("Rate").in(Unit::frames_per_second));
    }
};

} // namespace trivar
