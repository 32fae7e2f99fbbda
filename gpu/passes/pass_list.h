// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/cast.h"
#include "gpu/passes/contact_map.h"
#include "gpu/passes/layers.h"
#include "gpu/passes/lines.h"
#include "gpu/passes/occluders.h"
#include "gpu/passes/shadow_map.h"

#include <span>

namespace trivar::gpu {

// Brushes are the things with which passes draw, and which they keep from one picture to the next.
struct Brushes {
    Tools tools;
    ShadowMap shadow_map;
    ContactMap contact_map;
    Occluders occluders;
    LinePass lines, curves, outlined_curves;
    CastPass cast;
    SeeThroughPass see_through;
};

// A Work is a picture that is being drawn: its input, and how far it is.
struct Work {
    Picture picture;
    Scene scene;
    Frame frame;
    Look look;
    Quality quality;
    Targets* targets;
    glm::ivec2 shown_px; // the size before scaling
    int samples;
    int contact_px;            // side of the contact map
    bool contact_lags = false; // the existing contact map stays as it is, if there is one
    int sample = 0;            // number of the next sample
    std::size_t next = 0;      // number of the next pass of that sample
    bool in_light = false;     // the maps have been drawn
};

// A Pass is a part of drawing a picture. Its time is reported under its name; several passes may
// share a name.
struct Pass {
    const char* name;
    bool (*needed)(const Brushes&, const Work&); // whether the picture needs the pass
    void (*draw)(Brushes&, const Work&, const Frame&);
};

// The passes in their order: those before the samples, whose results all samples share; those of
// one sample, where a pass reads what earlier ones left in the targets; and those after the
// samples.
std::span<const Pass> passes_of_maps();
std::span<const Pass> passes_of_sample();
std::span<const Pass> passes_over_all();

} // namespace trivar::gpu
