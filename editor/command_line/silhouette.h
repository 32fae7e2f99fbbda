// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

struct SilhouetteCommand {
    std::string volume, out;
    std::vector<double> levels;           // none: where most of the volume's values part
    std::vector<std::string> names;       // of the layers of levels; none: level 1, level 2, ...
    std::vector<double> view{1, 1, -0.5}; // direction of sight, in the volume's own space
    std::vector<double> up;               // none: Z, or Y where one looks along Z
    double fov_deg = 0;                   // 0: parallel
    std::string size = "1000x1000";
    bool below = false; // the body is where values are less than the level
    bool smooth = false;
    std::vector<double> crop;     // shares of the grid: its first corner, then its last; none: all
    int coarsen = 1;              // see coarsened()
    int blur = 0;                 // see blurred()
    int memory_mb = 0;            // that may be used; 0: half of the machine's
    std::vector<double> spacing;  // mm between samples of files that do not say it; none: 1
    int time = 1;                 // of several volumes in the file, from 1
    bool whole_grid = false;      // is framed, whatever is drawn
    bool hide_each_other = false; // bodies of levels hide what is behind them of others
    std::string style = "plain";  // what the following ones change
    std::optional<double> width, taper, wobble, pencil, fans;
    std::optional<std::string> width_by, color_by;
    std::string hidden = "none", paper = "white";
    std::vector<std::string> colors; // by level, the last for all that follow
    int seed = 1;
    bool suggestive = false, ridges = false, valleys = false, parabolic = false;
    int isophotes = 0;
    std::vector<double> light{-0.5, -0.6, 0.65}; // toward it, in the volume's own space
    double smoothing = 2.4;                      // voxels, of what further lines are found by
    double detail = 1, amount = 1;
    std::string edited; // an .svg that a hand has changed; empty: none
    int dashes = 0;     // rows of the thesis's table; 0: connected lines
    int certified = -1; // halvings of a voxel; below 0: quick
};

// trivar silhouette.
Status run_silhouette(const SilhouetteCommand& command, const Streams& streams);

} // namespace trivar
