// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/document/document.h"
#include "editor/record/sequence.h"
#include "gpu/level.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A RecordingWish is frames of a scene that are to be drawn into files.
struct RecordingWish {
    Document document;
    Ref<AssetStore> assets;
    Sequence sequence; // its settings are added
    std::vector<int> frames;
    gpu::Level level = gpu::Level::standard;
    std::optional<Camera> camera; // none: the view that is kept for pictures
    std::string video;            // file; empty: none
};

} // namespace trivar
