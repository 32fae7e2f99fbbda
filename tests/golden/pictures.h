// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <gtest/gtest.h>
#include <string>

namespace trivar::testing {

// A PictureTolerance is the allowed difference between two machines that draw the same picture:
// rounding everywhere, edges by a sample here and there.
struct PictureTolerance {
    int step = 10;            // of 255, in any channel: more counts as a different pixel
    double share = 0.004;     // of the pixels that may be different
    double mean_steps = 0.75; // mean absolute difference of all channels
    double tile_steps = 4;    // the same over any 16 x 16 pixels: a thin line that is missing is
                              // little of a picture and much of them
};

// Compares with the picture `path`, relative to the source folder (tests/golden/NAME.png, or a
// picture of the docs). Where it fails it leaves NAME.out.png and NAME.diff.png (differences times
// 8) in the build folder. With TRIVAR_UPDATE_GOLDEN=1 in the environment it writes the picture
// instead, and passes.
::testing::AssertionResult matches_picture(const Image& image, const std::string& path,
                                           const PictureTolerance& tolerance = {});

} // namespace trivar::testing
