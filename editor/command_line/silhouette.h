// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"

#include <array>
#include <string>
#include <vector>

namespace trivar {

struct SilhouetteCommand {
    std::string volume, out;
    std::vector<double> levels;           // none: where most of the volume's values part
    std::vector<double> view{1, 1, -0.5}; // direction of sight, in the volume's own space
    std::vector<double> up;               // none: Z, or Y where one looks along Z
    double fov_deg = 0;                   // 0: parallel
    std::string size = "1000x1000";
    bool below = false; // the body is where values are less than the level
    bool smooth = false;
    int blur = 0; // see blurred()
    double width = 1.8;
    std::string width_by = "even", color_by = "plain", hidden = "none", paper = "white";
    double wobble = 0;
    int seed = 1;
    int certified = -1; // halvings of a voxel; below 0: quick
};

// trivar silhouette.
Status run_silhouette(const SilhouetteCommand& command, const Streams& streams);

} // namespace trivar
