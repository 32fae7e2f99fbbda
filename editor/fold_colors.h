// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "editor/volume_surface.h"
#include "ui/palette.h"

namespace trivar {

// The cells where a volume is proven to fold, and where that is not known. Nothing for what is
// proven good, nor for more cells than can be judged between two frames.
std::vector<gpu::Translucent> fold_veils(const Lattice& volume, const ui::Palette& color);

// The same, worked out once for each volume.
class FoldColors {
public:
    const std::vector<gpu::Translucent>& of(const Ref<Placement>& placement,
                                            const ui::Palette& color);

private:
    Ref<Placement> placement_;
    ui::Color bad_ = 0;
    std::vector<gpu::Translucent> veils_;
};

} // namespace trivar
