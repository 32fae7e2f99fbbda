// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/animated_files.h"

#include <string>

namespace trivar {

// An ExportWish is frames that are to be written as one file for other programs.
struct ExportWish {
    AnimatedScene scene;
    Ref<AssetStore> assets;
    std::string path; // its ending decides what it is
};

} // namespace trivar
