// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"

#include <optional>

namespace trivar::gpu {

// How much is spent on a sample.
struct Quality {
    int occlusion_slices = 2;                   // 0: no ambient occlusion
    int shadow_blockers = 12, shadow_taps = 16; // no blockers: shadows of one softness
    bool backs_of_bodies = true;                // which only folds show
    bool layers_at_once = false;                // of what one can see through
    std::vector<std::string> shadow_defines() const;
    std::vector<std::string> occlusion_defines() const;
    std::vector<std::string> blur_defines() const;
    // Of a pass over what one can see through, whose own ones are given.
    std::vector<std::string> ghost_defines(const std::vector<std::string>& of_layers) const;
};
// Noise averages over samples, so many samples need little each.
Quality quality_for(int samples, bool draft);

// The passes of one sample of a picture, in order. Each reads what the ones before left in the
// targets; contact and shadow map are bound.
// `clay`: the colour of what shows its form alone, if that is wanted.
void draw_surfaces(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                   const std::optional<glm::vec3>& clay, const Quality& quality);
void draw_occlusion(Tools& tools, const Targets& targets, const Quality& quality);
void draw_light(Tools& tools, const Targets& targets);
void draw_backdrop(Tools& tools, const Targets& targets, bool grid);
// Mixes the sample into the average of those before; `index` counts from 0.
void add_sample(Tools& tools, const Targets& targets, int index);
void draw_average(Tools& tools, const Targets& targets);
// Where the targets are deep: the colour as what is mixed as encoded goes over it, and back.
void encode_color(Tools& tools, const Targets& targets);
void decode_color(Tools& tools, const Targets& targets);

} // namespace trivar::gpu
