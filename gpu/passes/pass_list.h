// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/contact_map.h"
#include "gpu/passes/layers.h"
#include "gpu/passes/lines.h"
#include "gpu/passes/shadow_map.h"

#include <span>

namespace trivar::gpu {

// What passes draw with, and what they keep from one picture to the next.
struct Brushes {
    Tools tools;
    ShadowMap shadow_map;
    ContactMap contact_map;
    LinePass lines, curves, outlined_curves;
    SeeThroughPass see_through;
};

// A picture that is being drawn: what from, and how far it is.
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
    bool contact_lags = false; // the contact map stays as it is, where there is one
    int sample = 0;            // the next one
    std::size_t next = 0;      // of its passes
    bool in_light = false;     // the maps are drawn
};

// A part of drawing a picture. Its time is told by its name, which need not be its own.
struct Pass {
    const char* name;
    bool (*needed)(const Brushes&, const Work&); // by the picture that is drawn
    void (*draw)(Brushes&, const Work&, const Frame&);
};

// Each in its order: before the samples, which share what it draws; of one sample, where a pass
// reads what those before left in the targets; and after the samples.
std::span<const Pass> passes_of_maps();
std::span<const Pass> passes_of_sample();
std::span<const Pass> passes_over_all();

} // namespace trivar::gpu
