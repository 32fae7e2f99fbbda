// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/animated_model.h"
#include "core/files/source_files.h"

#include <optional>

namespace trivar {

// The endings of animated files: .glb, .usda, .pc2 and .mdd.
const std::vector<std::string>& animated_extensions();
// Throws Rejected where a name has none of these endings, or its folder does not exist.
void check_animated_name(const std::string& path);

// An AnimatedFile lists the written files. A .glb has a certificate.
struct AnimatedFile {
    std::vector<std::string> files;
    int frames = 0;
    std::optional<FilmCertificate> certificate;
    std::vector<std::string> tiles; // what became of each layer of tiles, if there are instances
    std::vector<std::string> lacks; // what the scene lacks at some moment
    std::string left_out;           // a sentence on what the format cannot hold; empty: nothing
};

// Writes the frames of a scene to a file, or several, each completely or not at all. The tolerance
// is for a .glb, and for instances in a .usda. No output replaces one of the sources. Throws
// Rejected, also where nothing is visible, and Cancelled.
AnimatedFile write_animated(const AnimatedScene& scene, const Ref<AssetStore>& assets,
                            const std::string& path, const Progress& progress = {},
                            const SourceFiles& sources = {});

// The statements of a certificate, one line each.
std::vector<std::string> summary(const FilmCertificate& certificate);

} // namespace trivar
