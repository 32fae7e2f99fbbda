// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/value_rows.h"

#include <cmath>
#include <imgui.h>

namespace trivar {

void ValueRows::triple(const std::string& label, glm::ivec3& value, const glm::ivec3& rest,
                       const ui::NumberStyle& style, const RowWords& words, const Names& names)
{
    const RowWords each_axis =
        words.parameters.empty() ? words : RowWords(words.help, axes_of(words.parameters.front()));
    const auto fields = [&](float width) {
        const float gap = theme.px(4), each = std::floor((width - 2 * gap) / 3);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ui::Edit any = ui::Edit::none;
        for (int i = 0; i < 3; ++i) {
            ui::NumberStyle one = style;
            one.axis = names[static_cast<std::size_t>(i)];
            ImGui::SetCursorScreenPos({at.x + static_cast<float>(i) * (each + gap), at.y});
            const ui::Edit e = ui::integer_field(theme, label + one.axis, value[i], one, each);
            if (e != ui::Edit::none) any = e;
        }
        return any;
    };
    row(label, value, rest, each_axis, fields, keys != nullptr);
}

} // namespace trivar
