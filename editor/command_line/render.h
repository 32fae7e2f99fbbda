// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/drawing.h"
#include "editor/command_line/scene_log.h"

#include <optional>

namespace trivar {

struct RenderOptions {
    SceneLog scene;
    std::string frames, out, shard; // as they are typed; no shard: all of them
    DrawingOptions drawing;
    std::optional<int> depth; // of a PNG, 8 or 16; 8
    bool resume = false;
    std::string video; // empty: none
    std::string sheet; // empty: a picture a frame; else COLUMNSxROWS of them in one, `out`
    int threads = 0;   // 0: as many as there are
};

// trivar render. Throws Rejected.
Status run_render(const RenderOptions& options, const Streams& streams);

} // namespace trivar
