// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

struct SaveCamera {
    static constexpr std::string_view verb = "save_camera",
                                      summary = "Keep a point of view under a name. The one named "
                                                "picture is what replay draws.";
    std::string name;
    Camera camera;
    bool operator==(const SaveCamera&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name of the bookmark; one of that name is replaced", required);
        field("camera", c.camera, "the point of view", required);
    }
};
struct DeleteCamera {
    static constexpr std::string_view verb = "delete_camera", summary = "Forget a point of view.";
    std::string name;
    bool operator==(const DeleteCamera&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name of the bookmark", required);
    }
};
template <> struct FieldsOf<RenderSettings> {
    static void fields(auto& s, auto&& field)
    {
        field("look", s.look, "light and background", one_of("studio|clay|dark"));
        field("exposure", s.exposure, "brightness, in stops", between(-20, 20));
        field("sun_azimuth", s.sun_azimuth, "where the sun stands round Z, 0 along +X, in radians",
              between(-100, 100));
        field("sun_elevation", s.sun_elevation,
              "how high the sun stands above the horizon, in radians", between(-1.6, 1.6));
        field("shadows", s.shadows, "the sun casts shadows");
        field("ambient_occlusion", s.ambient_occlusion, "corners are darker");
        field("wire", s.wire, "the edges of the faces are drawn over them", later);
        field("color_by", s.color_by,
              "what colours show: materials, how what was placed is stretched and squeezed, or how "
              "far its triangles may be from the true surface",
              later);
        field("volumes", s.volumes,
              "the volumes of what was placed are shown, with the ball of a press that was the "
              "last step of shaping",
              later);
        field("captions", s.captions,
              "under what is refined stand its triangles, how they were split and what of their "
              "error is certified",
              later);
        field("ground", s.ground, "a ground under the scene that catches shadows");
    }
};
template <> struct FieldsOf<Time> {
    static void fields(auto& t, auto&& field)
    {
        field("first_frame", t.first_frame, "where playing begins", between(-999999, 999999));
        field("last_frame", t.last_frame, "where it ends, itself shown", between(-999999, 999999));
        field("frames_per_second", t.frames_per_second, "how fast they follow each other",
              between(0.1, 1000));
    }
};
struct SetTime {
    static constexpr std::string_view verb = "set_time",
                                      summary = "Say which frames the scene has, as a whole.";
    Time time;
    bool operator==(const SetTime&) const = default;
    static void fields(auto& c, auto&& field) { FieldsOf<Time>::fields(c.time, field); }
};
struct SetRender {
    static constexpr std::string_view verb = "set_render",
                                      summary = "Say how the picture is made, as a whole.";
    RenderSettings settings;
    bool operator==(const SetRender&) const = default;
    static void fields(auto& c, auto&& field)
    {
        FieldsOf<RenderSettings>::fields(c.settings, field);
    }
};

} // namespace trivar
