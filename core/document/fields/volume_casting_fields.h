// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"
#include "core/document/volume_casting.h"

namespace trivar {

template <> struct FieldsOf<TransferPoint> {
    static constexpr std::string_view told_as = "[transfer point](#transfer-point)",
                                      about = "How a value of volume data looks.";
    static void fields(auto& p, auto&& field)
    {
        field("value", p.value, "of the data, in their own unit",
              required_in_range(-1e30, 1e30).called("Value"));
        field("color", p.color, "sRGB red, green, blue",
              in_range(0, 1).called("Colour").with_axes("red|green|blue"));
        field("opacity", p.opacity,
              "share of the light that a layer as thick as a voxel holds back; the thickness of a "
              "voxel is the cube root of its volume",
              in_range(0, 1).called("Opacity").in(Unit::share));
    }
};
template <> struct FieldsOf<VolumeCasting> {
    static constexpr std::string_view told_as = "[casting](#casting)",
                                      about = "How volume data are seen as a whole.";
    static void fields(auto& c, auto&& field)
    {
        field("shown", c.shown, "whether the data are seen as a whole, by rays cast through them",
              any_value.called("Casting").says("shown", "off"));
        field("points", c.points,
              "of the transfer function, with straight lines in between; none: made from the "
              "histogram of the data",
              any_value.called("Transfer function").zero_is("from the histogram"));
        field("density", c.density, "what the thickness of a voxel is multiplied by",
              in_range(0, 1000).called("Density").in(Unit::times));
        field("shading", c.shading, "0: colours as they are, 1: lit where values change",
              in_range(0, 1).called("Shading").in(Unit::share));
        field("crop_low", c.crop_low,
              "first corner of the box that is cast, as shares of the grid along its axes",
              in_range(0, 1).called("Cast from").in(Unit::share));
        field("crop_high", c.crop_high, "its last corner; each share is above that of the first",
              in_range(0, 1).called("Cast to").in(Unit::share));
    }
};

} // namespace trivar
