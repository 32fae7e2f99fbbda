// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "editor/volume_surface.h"
#include "ui/palette.h"

namespace trivar {

// How many control points of an axis are left where they are made a quarter fewer.
int fewer_points(const Knots& axis);

// The cells where a volume is proven to fold, and where that is not known. Nothing for what is
// proven good, nor for more cells than can be judged between two frames.
std::vector<gpu::Translucent> fold_veils(const Lattice& volume, const ui::Palette& color);

// What is known of the volume that is looked at, worked out once for each.
class VolumeFacts {
public:
    // As fold_veils.
    const std::vector<gpu::Translucent>& folds(const Ref<Placement>& placement,
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
