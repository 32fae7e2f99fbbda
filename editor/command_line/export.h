// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/scene_log.h"

#include <optional>

namespace trivar {

struct ExportOptions {
    SceneLog scene;
    std::string to;                // .glb, .pc2, .mdd or .usda
    std::string frames;            // A:B; empty: all of the scene's
    std::optional<double> epsilon; // metres; of a .glb, or of instances
    bool instances = false;        // in a .usda
    int threads = 0;               // 0: as many as there are
};

// trivar export. Throws Rejected and WrongUsage.
Status run_export(const ExportOptions& options, const Streams& streams);

} // namespace trivar
