// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "editor/volume_surface.h"
#include "ui/theme.h"

namespace trivar {

// Where a volume is proven to fold, and where that is not known; worked out once for each volume.
// Nothing for what is proven good, nor for more cells than can be judged between two frames.
class FoldColors {
public:
    const std::vector<gpu::Translucent>& of(const Ref<Placement>& placement,
                                            const ui::Theme& theme);

private:
    Ref<Placement> placement_;
    ui::Color bad_ = 0;
    std::vector<gpu::Translucent> veils_;
};

} // namespace trivar
