// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/incise/seen_incision.h"
#include "gpu/picture.h"
#include "ui/theme.h"

namespace trivar {

// A dashed line along a cut, for the scene; `strong`: it is the one that is selected.
std::vector<gpu::Line> dashes_of(const SeenIncision& cut, const Camera& camera,
                                 const ui::Theme& theme, bool strong);
// A faint net over what of the skin gives way beside a cut.
std::vector<gpu::Line> cage_of(const SeenIncision& cut, const ui::Theme& theme);

} // namespace trivar
