// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/line_fields.h"
#include "core/document/fields/surfacing_fields.h"
#include "core/document/fields/tetrahedra_fit_fields.h"
#include "core/document/fields/volume_casting_fields.h"
#include "core/document/voxel_shape.h"

namespace trivar {

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
    static constexpr std::string_view told_as = "[reading](#reading)",
                                      about = "What files of volume data do not say.";
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
        field("coarsen", r.coarsen,
              "how many samples along each axis become one, their mean, while the files are read: "
              "for data larger than memory",
              later_in_range(1, 64).called("Kept").resting_at(1).without_keys());
    }
};
template <> struct FieldsOf<VoxelLevel> {
    static constexpr std::string_view told_as = "[level](#level)",
                                      about = "A level of volume data as it is shown.";
    static void fields(auto& l, auto&& field)
    {
        field("name", l.name, "what it is called; empty: by its value");
        field("value", l.value, "of the data at the level, in their own unit",
              required_in_range(-1e30, 1e30).called("Level"));
        field("hidden", l.hidden, "nothing of it is shown");
        field("surface", l.surface, "whether its surface is shown",
              any_value.called("Surface").says("shown", "off"));
        spread(l.look, field);
        field("lines", l.lines, "whether its silhouettes are drawn",
              any_value.called("Lines").says("drawn", "off"));
        field("ink", l.ink, "how its lines are drawn");
        field(
            "certified", l.certified,
            "whether its silhouettes are proven to lack nothing larger than an eighth of a voxel: "
            "in pictures and drawings, and in the window while the view rests",
            later.called("Certified").says("to 1/8 voxel", "off"));
        field("more", l.more, "further lines", later);
    }
};
template <> struct FieldsOf<VoxelShape> {
    static constexpr std::string_view verb = "add_volume",
                                      summary = "Add volume data from a file or a folder, with "
                                                "levels that are shown as surfaces and lines.",
                                      name = "Volume data", copied = "volume_data";
    static void fields(auto& s, auto&& field)
    {
        field("path", s.path, "file or folder, relative to the scene file's folder",
              required.without_keys().names_file(FileKind::volume));
        field("hash", s.hash, "digest of its content; empty: any",
              any_value.without_keys().digest_of_file());
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
        field("crop_low", s.crop_low,
              "first corner of the box of the data that is shown, as shares of the grid along its "
              "axes; the nearest samples count",
              in_range(0, 1).called("Crop from").in(Unit::share).counts(Counting::named));
        field(
            "crop_high", s.crop_high, "its last corner; each share is above that of the first",
            in_range(0, 1).called("Crop to").in(Unit::share).resting_at(1).counts(Counting::named));
        field("levels", s.levels, "that are shown; none: one that parts the values best");
        field("fit", s.fit, "by a spline over tetrahedra", later.without_keys());
        field("casting", s.casting, "how the data are seen as a whole", later);
        field("reading", s.reading, "what its files do not say, and how much is kept",
              later.without_keys());
    }
};

} // namespace trivar
