// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <string>
#include <vector>

namespace trivar {

// Throws Rejected where the name ends as no video does that is made here (.mp4, .mov, .mkv), or
// where there is no ffmpeg.
void check_video(const std::string& path);

// A video of pictures, in their order, by the program ffmpeg, which gets them one after another;
// written beside the file, then renamed: any failure, Cancelled among them, leaves what was there.
// Sizes of an odd number get another row or column. Throws Rejected.
void write_video(const std::vector<std::string>& pictures, double frames_per_second,
                 const std::string& path, const Progress& progress = {});

} // namespace trivar
