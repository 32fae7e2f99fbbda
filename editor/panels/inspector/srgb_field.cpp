// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/srgb_field.h"

#include <glm/gtc/color_space.hpp>

namespace trivar {

ui::Edit srgb_field(const ui::Theme& theme, const std::string& id, glm::vec3& srgb, float width)
{
    glm::vec4 linear(glm::convertSRGBToLinear(srgb), 1);
    const ui::Edit edit = ui::color_field(theme, id, linear, width);
    if (edit == ui::Edit::changed)
        srgb = glm::round(glm::convertLinearToSRGB(glm::vec3(linear)) * 255.0f) / 255.0f;
    return edit;
}

} // namespace trivar
