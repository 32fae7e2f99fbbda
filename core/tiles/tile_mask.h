// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace trivar {

// The property of the tiles that a mask drives.
enum class MaskDrives { density, scale, height, morph };

// The source of a mask's values.
enum class MaskFrom {
    image, // a picture
    line,  // 0 at a first point to 1 at a second one
    point, // 1 round a point to 0 away from it
    curve  // the same round the curves of an object
};

// The way in which an image lies on the base at rest.
enum class MaskLies {
    uv,             // by its texture coordinates
    along_x,        // seen along an axis, stretched over the base's box
    along_y,        //
    along_z,        //
    from_six_sides, // along the axis to which the normal is nearest
};

// The shape of a gradient from 0 to 1.
enum class MaskEasing { even, smooth, slow_start, slow_end };

// A TileMask is a factor of the tiles of a layer that depends on where they are on the base at
// rest; lengths are metres on its model. Masks that drive the same multiply. The value of a
// gradient round a point or a curve, and the factor:
//
//    1 |------.                     factor = low + (high - low) * value
//      |       `.
//    0 +---------`-------- distance
//          start  stop
struct TileMask {
    MaskDrives drives = MaskDrives::density;
    MaskFrom from = MaskFrom::line;
    double low = 0, high = 1; // the factor where its value is 0, and where it is 1
    bool inverted = false;
    bool hidden = false; // it does nothing
    // The image, if the values come from one.
    std::string image = {}, image_hash = {}; // as of an ImportedFile
    MaskLies lies = MaskLies::uv;
    double repeat_u = 1, repeat_v = 1, shift_u = 0, shift_v = 0; // in images
    // The gradient, if the values come from one.
    glm::dvec3 begin{0}, end{0, 0, 1}; // of a line; `begin` is the point
    int curve = 0;                     // id of an object; 0: none
    double start = 0, stop = 1;        // distances at which the value is 1, and 0
    MaskEasing easing = MaskEasing::even;
    bool operator==(const TileMask&) const = default;
};

} // namespace trivar
