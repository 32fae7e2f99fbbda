// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "editor/panels/help/welcome.h"
#include "ui/keys.h"

#include <algorithm>
#include <array>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

struct Arrow {
    int key;
    glm::vec2 direction;
};
constexpr std::array<Arrow, 4> arrows{{
    {ui::key_left, {-1, 0}},
    {ui::key_right, {1, 0}},
    {ui::key_up, {0, -1}},
    {ui::key_down, {0, 1}},
}};

// Nobody else has the keyboard.
bool listens(const Editor& editor)
{
    return editor.panel == Editor::Panel::view && !editor.active_tool().busy() &&
           !editor.files.asking() && !ImGui::IsAnyItemActive() &&
           !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
}

} // namespace

int next_entry(const std::vector<ui::Rect>& entries, int at, glm::vec2 direction)
{
    const ui::Rect& from = entries[static_cast<std::size_t>(at)];
    int nearest = at;
    float least = 1e9f;
    for (int i = 0; i < std::ssize(entries); ++i) {
        const ui::Rect& to = entries[static_cast<std::size_t>(i)];
        const float ahead = glm::dot(to.center() - from.center(), direction);
        const glm::vec2 gap =
            glm::max(glm::max(to.lo - from.hi, from.lo - to.hi), glm::vec2(0)); // between them
        const float along = glm::dot(gap, glm::abs(direction));
        const float aside = gap.x + gap.y - along;
        const bool that_way = ahead > 0 && along > 0; // none of those beside it
        const float far = along + 2 * aside;
        if (i == at || !that_way || far >= least) continue;
        least = far;
        nearest = i;
    }
    return nearest;
}

void move_keyboard(Editor& editor)
{
    Editor::StartCard& card = editor.start_card;
    const std::vector<ui::Rect> entries = std::exchange(card.entries, {});
    const int count = static_cast<int>(entries.size());
    if (card.at >= count || ImGui::IsMouseClicked(ImGuiMouseButton_Left)) card.at = -1;
    if (count == 0 || !listens(editor)) return;
    if (ui::struck({ui::key_tab}, true)) card.at = (card.at + 1) % count;
    if (ui::struck({.key = ui::key_tab, .shift = true}, true))
        card.at = (std::max(card.at, 0) + count - 1) % count;
    for (const Arrow& arrow : arrows)
        if (ui::struck({arrow.key}, true))
            card.at = card.at < 0 ? 0 : next_entry(entries, card.at, arrow.direction);
}

bool is_chosen(Editor& editor, const ui::Theme& theme, const ui::Rect& r, bool clicked)
{
    Editor::StartCard& card = editor.start_card;
    card.entries.push_back(r);
    if (card.at != std::ssize(card.entries) - 1) return clicked;
    ui::paint_rim(r.grown(theme.px(2)), theme.color.focus, theme.size.rounding + theme.px(2),
                  1.5f * theme.scale);
    const bool enter = ui::struck({ui::key_enter}) || ui::struck({ui::key_keypad_enter});
    if (clicked || !enter || !listens(editor)) return clicked;
    ui::swallow_keys(); // it is not the dialog's that opens now
    return true;
}

} // namespace trivar
