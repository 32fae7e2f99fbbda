// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/surfacing_fields.h"
#include "core/document/fields/volume_casting_fields.h"
#include "core/document/voxel_shape.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<LineWidth>{"even", "slope", "depth",
                                                                         "bend"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<LineColor>{"plain", "slope", "depth",
                                                                         "grey"};
template <>
inline constexpr std::array<std::string_view, 4> choice_words<LineColor>{
    "plain", "hue by slope", "hue by depth", "grey by slope"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<HiddenLines>{"none", "faint",
                                                                           "dashed", "seen"};
template <>
inline constexpr std::array<std::string_view, 2> choice_names<FieldSpline>{"interpolating",
                                                                           "smoothing"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<FieldOrder>{"linear", "quadratic",
                                                                          "cubic"};
template <>
inline constexpr std::array<std::string_view, 2> choice_names<LevelSide>{"above", "below"};

template <>
inline constexpr std::array<std::string_view, 10> choice_names<SampleType>{
    "u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64", "f32", "f64"};
template <>
inline constexpr std::array<std::string_view, 2> choice_names<ByteOrder>{"little", "big"};

template <> struct FieldsOf<VolumeReading> {
    static constexpr std::string_view told_as = "[reading](#reading)";
    static void fields(auto& r, auto&& field)
    {
        field("size", r.size,
              "number of samples along each axis of a file without a head; 0: as its name says",
              in_range(0, 1e9).called("Size").without_keys());
        field("type", r.type, "of its samples: signed, unsigned or floating point, and bits",
              any_value.called("Type").without_keys());
        field("order", r.order, "of the bytes of a sample",
              any_value.called("Byte order").without_keys());
        field("header_bytes", r.header_bytes, "before the samples",
              in_range(0, 2e9).called("Header").without_keys());
        field("spacing_mm", r.spacing_mm,
              "between samples of files that do not say it, millimetres",
              in_range(1e-9, 1e9).called("Spacing").without_keys());
    }
};
template <> struct FieldsOf<LineStyle> {
    static constexpr std::string_view told_as = "[lines](#lines)";
    static void fields(auto& s, auto&& field)
    {
        field("width", s.width, "of the lines, pixels", in_range(0.05, 100).called("Line width"));
        field("finest", s.finest, "share of the width down to which a line may become fine",
              in_range(0, 1).called("Finest").in(Unit::share));
        field("width_by", s.width_by,
              "what the width follows: nothing, the slope of the data (steep: fine), the depth "
              "(far: fine), or how sharply the surface turns away (sharp: fine)",
              any_value.called("Width by").without_keys());
        field("color_by", s.color_by,
              "what the colour follows: nothing, the slope or the depth as a hue from red to blue, "
              "or the slope as a grey",
              any_value.called("Colour by").without_keys());
        field("color", s.color, "sRGB red, green, blue",
              in_range(0, 1).called("Line colour").with_axes("red|green|blue"));
        field("taper", s.taper, "length over which a loose end becomes fine, pixels",
              in_range(0, 1000).called("Taper"));
        field("wobble", s.wobble,
              "greatest distance of a line from its place, as of a hand; pixels",
              in_range(0, 100).called("Wobble").zero_is("none"));
        field("pencil", s.pencil,
              "how far a line is like a pencil's: drawn three times, of uneven width",
              in_range(0, 1).called("Pencil").in(Unit::share).zero_is("pen"));
        field("fan_step", s.fan_step,
              "pixels between the fans that tell how the data fall off outside a line",
              in_range(0, 1000).called("Fans every").zero_is("none"));
        field("fan_length", s.fan_length, "of the longest hairs of a fan, pixels",
              in_range(0.1, 1000).called("Fan length"));
        field("seed", s.seed, "of the wobble and the pencil", any_value.called("Seed").without_keys());
        field("hidden_lines", s.hidden, "how hidden lines are drawn",
              any_value.called("Hidden lines").without_keys());
    }
};
template <> struct FieldsOf<VoxelLevel> {
    static constexpr std::string_view told_as = "[level](#level)";
    static void fields(auto& l, auto&& field)
    {
        field("name", l.name, "what it is called; empty: by its value");
        field("value", l.value, "of the data at the level, in their own unit",
              required_in_range(-1e30, 1e30).called("Level"));
        field("hidden", l.hidden, "nothing of it is shown");
        field("surface", l.surface, "whether its surface is shown",
              any_value.called("Surface").says("shown", "off"));
        FieldsOf<Surfacing>::fields(l.look, field);
        field("lines", l.lines, "whether its silhouettes are drawn",
              any_value.called("Lines").says("drawn", "off"));
        field("ink", l.ink, "how its lines are drawn");
    }
};
template <> struct FieldsOf<VoxelShape> {
    static constexpr std::string_view verb = "add_volume",
                                      summary = "Add volume data from a file or a folder, with "
                                                "levels that are shown as surfaces and lines.",
                                      name = "Volume data";
    static void fields(auto& s, auto&& field)
    {
        field("path", s.path, "file or folder, relative to the scene file's folder",
              required.without_keys());
        field("hash", s.hash, "digest of its content; empty: any", any_value.without_keys());
        field("scale", s.scale, "metres in the scene per metre of the data",
              in_range(1e-9, 1e9).called("Scale"));
        field("order", s.order, "of the spline through the samples",
              any_value.called("Spline").without_keys());
        field("spline", s.spline,
              "interpolating: through the samples; smoothing: the samples are its control points",
              any_value.called("Samples").without_keys());
        field("coarsen", s.coarsen,
              "how many samples along each axis become one, their mean: less memory, less detail",
              in_range(1, 64).called("Coarsen").resting_at(1).counts(Counting::named));
        field("blur", s.blur, "how often the samples are smoothed before",
              in_range(0, 64).called("Blur").zero_is("none"));
        field("body", s.body, "on which side of its level a body is",
              any_value.called("Body").without_keys());
        field("levels", s.levels, "that are shown; none: one that parts the values best");
        field("casting", s.casting, "how the data are seen as a whole", later);
        field("reading", s.reading, "what its files do not say", later.without_keys());
    }
};

} // namespace trivar
