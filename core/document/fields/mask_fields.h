// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<MaskDrives>{"density", "scale",
                                                                          "height", "morph"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<MaskFrom>{"image", "line", "point",
                                                                        "curve"};
template <>
inline constexpr std::array<std::string_view, 5> choice_names<MaskLies>{
    "uv", "along_x", "along_y", "along_z", "from_six_sides"};
template <>
inline constexpr std::array<std::string_view, 5> choice_words<MaskLies>{
    "texture coordinates", "along X", "along Y", "along Z", "from six sides"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<MaskEasing>{"even", "smooth",
                                                                          "slow_start", "slow_end"};

template <> struct FieldsOf<TileMask> {
    static constexpr std::string_view told_as = "[tile mask](#tile-mask)",
                                      about =
                                          "Where a layer has more tiles, larger or higher ones.",
                                      copied_as = "[copied mask](#copied-mask)";
    static void fields(auto& m, auto&& field)
    {
        field("drives", m.drives, "what of the tiles it drives", any_value.without_keys());
        field("from", m.from,
              "a picture; or a gradient: from a first point to a second one, round a point, or "
              "round the curves of an object",
              any_value.without_keys());
        field("low", m.low, "factor of the tiles where the mask is black",
              in_range(0, 100).called("At black").in(Unit::times));
        field("high", m.high, "factor of the tiles where the mask is white",
              in_range(0, 100).called("At white").in(Unit::times));
        field("inverted", m.inverted, "black and white change places", any_value.without_keys());
        field("hidden", m.hidden, "it does nothing",
              any_value.without_keys().called("Mask").says("off", "on"));
        field("image", m.image, "file of the picture, relative to the scene file's folder",
              any_value.without_keys().names_file(FileKind::image, m.from == MaskFrom::image));
        field("image_hash", m.image_hash, "digest of that file's content; empty: any",
              any_value.without_keys().digest_of_file());
        field("lies", m.lies,
              "how the picture lies on the base at rest: by its texture coordinates, or stretched "
              "over its box, along an axis or the one nearest to the normal",
              any_value.without_keys());
        field("repeat_u", m.repeat_u, "how often the picture lies side by side",
              in_range(-1000, 1000).called("Repeat across"));
        field("repeat_v", m.repeat_v, "how often it lies one above the other",
              in_range(-1000, 1000).called("Repeat up"));
        field("shift_u", m.shift_u, "how far it is moved to the left, in pictures",
              in_range(-1000, 1000).called("Shift across"));
        field("shift_v", m.shift_v, "how far it is moved down, in pictures",
              in_range(-1000, 1000).called("Shift up"));
        field("begin", m.begin, "where a line is black, or the point of a gradient round a point",
              any_value.called("From").in(Unit::metres));
        field("end", m.end, "where a line is white", any_value.called("To").in(Unit::metres));
        field("start", m.start,
              "up to this distance from the point or the curve the mask is white, metres on the "
              "model",
              not_negative.called("White within").in(Unit::metres));
        field("stop", m.stop, "from this distance on it is black, metres on the model",
              not_negative.called("Black from").in(Unit::metres));
        field("easing", m.easing, "how a gradient goes from black to white",
              any_value.without_keys());
        field("curve", m.curve, "id of the object with the curves; 0: none",
              in_range(0, 1e9).without_keys().names_object("masked by").copied_as("around"));
    }
};

} // namespace trivar
