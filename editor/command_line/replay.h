// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/drawing.h"
#include "editor/command_line/scene_log.h"

#include <optional>

namespace trivar {

struct ReplayOptions {
    SceneLog scene;
    int to = 0;                    // line of the file; 0: all
    std::optional<int> frame;      // nothing: the first
    std::optional<double> epsilon; // metres; nothing: what the scene says
    std::vector<std::string> exports;
    bool instances = false; // in a .glb, tiles within epsilon, or default_tolerance
    std::string image;
    DrawingOptions drawing;
    bool check = false, digest = false;
    std::string timings;
    int threads = 0; // 0: as many as there are
};

// trivar replay. Throws Rejected.
Status run_replay(const ReplayOptions& options, const Streams& streams);

} // namespace trivar
