// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

namespace trivar {

// A colour that is told in sRGB, in the field for linear ones.
ui::Edit srgb_field(const ui::Theme& theme, const std::string& id, glm::vec3& srgb, float width);

} // namespace trivar
