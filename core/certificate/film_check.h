// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/animated_export.h"

namespace trivar {

// What a part of a file that moves was found to be.
struct FilmSample {
    std::size_t samples = 0;
    double furthest = 0;            // of what the file shows from the scene, metres
    double at_frame = 0;            // there
    double furthest_at_moments = 0; // of the film, of what is not proven between them
    double reach = 0;               // the length of the furthest place
};

// Evaluates the scene anew, so many times a frame, and what the file's clip shows then, by the
// rules of glTF: at every vertex and, of what lies in a volume, in the middle of every triangle.
// What is claimed for the film's moments alone is looked at there, too. By part of the certificate.
// One moment at a time is in memory. Where something comes or goes between two frames it is not
// looked at in between. Throws Cancelled.
std::vector<FilmSample> sampled_film(const AnimatedExport& exported, const Document& document,
                                     const Ref<AssetStore>& assets, int per_frame,
                                     const Progress& progress = {});

} // namespace trivar
