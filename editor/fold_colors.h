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
    // Null where there are too many cells.
    const CellVerdicts* verdicts(const Ref<Placement>& placement);
    // How far anything moves at most where an axis is left fewer_points(); none: that is not known.
    const std::array<std::optional<double>, 3>& deviations(const Ref<Placement>& placement);

private:
    void judge_again(const Ref<Placement>& placement);
    Ref<Placement> placement_;
    std::optional<CellVerdicts> verdicts_;
    ui::Color bad_ = 0; // that the veils are drawn in; 0: they are not yet
    std::vector<gpu::Translucent> veils_;
    Ref<Placement> coarsened_;
    std::array<std::optional<double>, 3> deviations_;
};

} // namespace trivar
