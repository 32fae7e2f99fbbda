// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <string>
#include <vector>

namespace trivar {

// Throws Rejected where the name does not end as a video that can be made here (.mp4, .mov, .mkv),
// or where there is no ffmpeg.
void check_video(const std::string& path);

// Makes a video of pictures, in their order, with the program ffmpeg, which gets them one after
// another. It is written beside the file, then renamed: any failure, also Cancelled, leaves the
// earlier file. Odd sizes get another row or column. Throws Rejected.
void write_video(const std::vector<std::string>& pictures, double frames_per_second,
                 const std::string& path, const Progress& progress = {});

} // namespace trivar
