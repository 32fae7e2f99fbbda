// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/stage.h"

namespace trivar {

// The materials beside those of the shape, and the number of the one that caps show.
struct InsideMaterial {
    Ref<std::vector<Material>> beside;
    std::uint32_t number = 0;
};

// A pattern as one more material of a stage; none: the first one that it has.
InsideMaterial inside_material(const Stage& stage, Filling filling);

// The material that a surfacing stands for.
Material material_of(const Surfacing& surfacing);

// Whether a pattern fills a part of the stage, so that it follows the former places of points.
bool is_filled(const Stage& stage, Filling inside, const std::optional<Surfacing>& surfacing);

} // namespace trivar
