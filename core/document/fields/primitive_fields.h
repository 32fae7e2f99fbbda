// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<PlaneShape> {
    static constexpr std::string_view verb = "add_plane", summary = "Add a plane in z = 0.",
                                      name = "Plane";
    static void fields(auto& s, auto&& field)
    {
        field("size", s.size, "along X and Y, metres", positive.in(Unit::metres));
        field("segments", s.segments, "along X and Y", in_range(1, 2000));
    }
};

template <> struct FieldsOf<BoxShape> {
    static constexpr std::string_view verb = "add_box", summary = "Add a box.", name = "Box";
    static void fields(auto& s, auto&& field)
    {
        field("size", s.size, "along X, Y and Z, metres", positive.in(Unit::metres));
        field("segments", s.segments, "along X, Y and Z", in_range(1, 500));
    }
};

template <> struct FieldsOf<SphereShape> {
    static constexpr std::string_view verb = "add_sphere", summary = "Add a sphere.",
                                      name = "Sphere";
    static void fields(auto& s, auto&& field)
    {
        field("radius", s.radius, "metres", positive.in(Unit::metres));
        field("segments", s.segments, "around the axis", in_range(3, 2000));
        field("rings", s.rings, "from pole to pole", in_range(2, 1000));
    }
};

template <> struct FieldsOf<CylinderShape> {
    static constexpr std::string_view verb = "add_cylinder", summary = "Add a closed cylinder.",
                                      name = "Cylinder";
    static void fields(auto& s, auto&& field)
    {
        field("radius", s.radius, "metres", positive.in(Unit::metres));
        field("height", s.height, "metres", positive.in(Unit::metres));
        field("segments", s.segments, "around the axis", in_range(3, 2000));
        field("stacks", s.stacks, "along the axis", in_range(1, 2000));
    }
};

template <> struct FieldsOf<TorusShape> {
    static constexpr std::string_view verb = "add_torus", summary = "Add a torus.", name = "Torus";
    static void fields(auto& s, auto&& field)
    {
        field("radius", s.radius, "of the middle circle, metres", positive.in(Unit::metres));
        field("tube", s.tube, "radius of the tube, metres", positive.in(Unit::metres));
        field("segments", s.segments, "around the axis and round the tube", in_range(3, 2000));
    }
};

template <> struct FieldsOf<MoebiusShape> {
    static constexpr std::string_view verb = "add_moebius", summary = "Add a Moebius band.",
                                      name = "Moebius band";
    static void fields(auto& s, auto&& field)
    {
        field("radius", s.radius, "of the middle circle, metres", positive.in(Unit::metres));
        field("width", s.width, "metres", positive.in(Unit::metres));
        field("segments", s.segments, "around the axis and across", in_range(1, 2000));
    }
};

template <> struct FieldsOf<TeapotShape> {
    static constexpr std::string_view verb = "add_teapot", summary = "Add the Utah teapot.",
                                      name = "Teapot";
    static void fields(auto& s, auto&& field)
    {
        field("height", s.height, "metres", positive.in(Unit::metres));
        field("resolution", s.resolution, "samples along each side of its 32 patches",
              in_range(1, 64));
    }
};

template <> inline constexpr std::array<std::string_view, 2> choice_names<HeightsLie>{"face", "uv"};
template <>
inline constexpr std::array<std::string_view, 2> choice_words<HeightsLie>{"each tile", "all UVs"};

template <> struct FieldsOf<HeightShape> {
    static constexpr std::string_view verb = "add_heights",
                                      summary = "Add a square sheet in z = 0 that stands as high "
                                                "as a picture is bright, to be used as a tile.",
                                      name = "Heights";
    static void fields(auto& s, auto&& field)
    {
        field("image", s.image, "file of the picture, relative to the scene file's folder",
              required.without_keys().names_file(FileKind::image));
        field("image_hash", s.image_hash, "digest of that file's content; empty: any",
              any_value.without_keys().digest_of_file());
        field("size", s.size, "side, metres", positive.in(Unit::metres));
        field("height", s.height, "from black to white, metres",
              in_range(-1e6, 1e6).in(Unit::metres));
        field("level", s.level, "brightness that stays on the ground: 0 black, 1 white",
              in_range(-1e6, 1e6));
        field("segments", s.segments, "along each side", in_range(1, 512));
        field("repeats", s.repeats, "the picture goes on over its border, so that copies fit",
              any_value.without_keys());
        field("lies", s.lies,
              "over what the picture lies where the sheet covers an object: once over each tile, "
              "or over the UVs of the object, each point P of it at P + h(u, v) N",
              later.called("Picture over").without_keys());
    }
};

} // namespace trivar
