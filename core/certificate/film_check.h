// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/animated_export.h"

namespace trivar {

// A FilmSample is the result of sampling one part of a file that moves.
struct FilmSample {
    std::size_t samples = 0;
    double furthest = 0; // largest distance between file and scene, metres
    double at_frame = 0; // where that distance was found
    // the same at the film's moments, where nothing is proven between them
    double furthest_at_moments = 0;
    double reach = 0; // length of the furthest place, metres
};

// Compares a file's clip with the scene, which is evaluated anew: at every vertex and, for parts in
// a volume, in the middle of every triangle, by the rules of glTF.
//   per_frame  number of times per frame; parts whose claim holds only at the film's moments are
//              compared at these too
// The result has one entry per part of the certificate. One moment at a time is in memory. A part
// that appears or disappears between two frames is not compared between them. Throws Cancelled.
std::vector<FilmSample> sampled_film(const AnimatedExport& exported, const Document& document,
                                     const Ref<AssetStore>& assets, int per_frame,
                                     const Progress& progress = {});

} // namespace trivar
