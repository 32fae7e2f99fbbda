// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"

#include <optional>

namespace trivar::gpu {

// A Quality says how much is spent on a sample.
struct Quality {
    int occlusion_slices = 2;                   // 0: no ambient occlusion
    int shadow_blockers = 12, shadow_taps = 16; // no blockers: shadows of one softness
    bool backs_of_bodies = true;                // which only folds show
    bool layers_at_once = false;                // of see-through things
    int cast_divisor = 1;                       // of the size of what is cast through volumes
    float cast_pace = 0.5f;                     // voxels in a step of a ray
    std::vector<std::string> shadow_defines() const;
    std::vector<std::string> occlusion_defines() const;
    std::vector<std::string> blur_defines() const;
    // The defines of a pass over see-through things, added to the pass's own.
    std::vector<std::string> ghost_defines(const std::vector<std::string>& of_layers) const;
};
// The quality for a number of samples: noise averages out over samples, so each of many may be
// coarse.
Quality quality_for(int samples, bool draft);

// These functions are the passes of one sample of a picture, in order. Each reads what earlier ones
// left in the targets; contact and shadow map must be bound. `clay`: the colour that replaces all
// materials, to show only the form; null: none.
void draw_surfaces(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                   const std::optional<glm::vec3>& clay, const Quality& quality);
void draw_occlusion(Tools& tools, const Targets& targets, const Quality& quality);
void draw_light(Tools& tools, const Targets& targets);
void draw_backdrop(Tools& tools, const Targets& targets, bool grid);
// Mixes the sample into the average of those before; `index` counts from 0.
void add_sample(Tools& tools, const Targets& targets, int index);
void draw_average(Tools& tools, const Targets& targets);
// Encodes the colours of deep targets for layers that are mixed as encoded colours, and decodes
// them.
void encode_color(Tools& tools, const Targets& targets);
void decode_color(Tools& tools, const Targets& targets);

} // namespace trivar::gpu
