// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/animated_model.h"
#include "core/files/source_files.h"

#include <optional>

namespace trivar {

// The endings of animated files: .glb, .usda, .pc2 and .mdd.
const std::vector<std::string>& animated_extensions();
// Throws Rejected where a name has none of them, or its folder is not there.
void check_animated_name(const std::string& path);

// What was written. A .glb has a certificate.
struct AnimatedFile {
    std::vector<std::string> files;
    int frames = 0;
    std::optional<FilmCertificate> certificate;
    std::vector<std::string> lacks; // what the scene does at some moment
    std::string left_out;           // what the format has not, as a sentence; empty: nothing
};

// The frames of a scene to a file, or several, each whole or not there. The tolerance is a .glb's.
// None takes the place of one of the sources. Throws Rejected, also where nothing is visible, and
// Cancelled.
AnimatedFile write_animated(const AnimatedScene& scene, const Ref<AssetStore>& assets,
                            const std::string& path, const Progress& progress = {},
                            const SourceFiles& sources = {});

// What a certificate says, a line each.
std::vector<std::string> summary(const FilmCertificate& certificate);

} // namespace trivar
