// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/value_rows.h"

#include "editor/panels/inspector/field_cells.h"

#include <imgui.h>

namespace trivar {

void ValueRows::triple(const std::string& label, glm::ivec3& value, const glm::ivec3& rest,
                       const ui::NumberStyle& style, const RowWords& words, const Names& names)
{
    const RowWords each_axis =
        words.parameters.empty() ? words : RowWords(words.help, axes_of(words.parameters.front()));
    const auto fields = [&](float width) {
        const FieldCells cells(theme, width, 3);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ui::Edit any = ui::Edit::none;
        for (int i = 0; i < 3; ++i) {
            ui::NumberStyle one = style;
            one.axis = names[static_cast<std::size_t>(i)];
            const glm::vec2 off = cells.offset(i);
            ImGui::SetCursorScreenPos({at.x + off.x, at.y + off.y});
            const ui::Edit e =
                ui::integer_field(theme, label + one.axis, value[i], one, cells.width);
            if (e != ui::Edit::none) any = e;
        }
        return any;
    };
    row(label, value, rest, each_axis, fields, keys != nullptr);
}

} // namespace trivar
