// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include "ui/camera_control.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

constexpr float labels_px = 130; // of the picture's width, at its left

struct Axis {
    glm::dvec3 direction;
    ui::Color color;
    const char* name; // empty: the negative end
};

} // namespace

bool has_room_for_axes(const ui::Theme& theme, const ui::Rect& view)
{
    return view.width() >= theme.px(labels_px + 112);
}

void draw_navigation(Editor& editor, const ui::Theme& theme, const ui::Rect& view,
                     const std::optional<ui::Rect>& card)
{
    const auto on_card = [&](const ui::Rect& r) {
        return card && r.lo.x < card->hi.x && r.hi.x > card->lo.x && r.lo.y < card->hi.y &&
               r.hi.y > card->lo.y;
    };
    const ui::Palette& c = theme.color;
    Camera& camera = editor.session.view.camera;
    const glm::vec2 middle{view.hi.x - theme.px(56), view.lo.y + theme.px(56)};
    const float reach = theme.px(32);
    if (!has_room_for_axes(theme, view) || on_card({middle - theme.px(44), middle + theme.px(44)}))
        return;
    ui::paint_dot(middle, theme.px(44), ui::rgb(0x0E0F11, 0.22f));
    ui::lower_area("axes", {middle - theme.px(44), middle + theme.px(44)});
    std::array<Axis, 6> axes{{{{1, 0, 0}, c.axis_x, "X"},
                              {{0, 1, 0}, c.axis_y, "Y"},
                              {{0, 0, 1}, c.axis_z, "Z"},
                              {{-1, 0, 0}, c.axis_x, ""},
                              {{0, -1, 0}, c.axis_y, ""},
                              {{0, 0, -1}, c.axis_z, ""}}};
    const glm::dmat4 to_view = view_matrix(camera);
    const auto seen = [&](const Axis& axis) {
        return glm::vec3(to_view * glm::dvec4(axis.direction, 0));
    };
    std::sort(axes.begin(), axes.end(),
              [&](const Axis& a, const Axis& b) { return seen(a).z < seen(b).z; });
    for (const Axis& axis : axes) {
        const glm::vec3 d = seen(axis);
        const glm::vec2 p = middle + glm::vec2(d.x, -d.y) * reach;
        const float radius = *axis.name ? theme.px(9) : theme.px(6);
        const ui::Rect disc{p - radius, p + radius};
        ImGui::PushID(&axis - axes.data());
        ImGui::SetCursorScreenPos({disc.lo.x, disc.lo.y});
        if (ImGui::InvisibleButton("axis", {2 * radius, 2 * radius}))
            editor.session.view.look_from(axis.direction);
        const bool hot = ImGui::IsItemHovered();
        const char* side = std::ranges::find(viewpoints(), axis.direction, &Viewpoint::from)->name;
        ui::tooltip({side, key_text(action(editor, side)), "Looks at the scene from there."});
        ImGui::PopID();
        if (*axis.name) {
            ui::paint_line(middle, p, axis.color, 2 * theme.scale);
            ui::paint_dot(p, radius, axis.color, c.selected, hot ? 1.5f * theme.scale : 0);
            ui::paint_text(theme.font.small_strong, disc, ui::rgb(0x111214), axis.name,
                           ui::Align::center);
        } else {
            ui::paint_dot(p, radius, ui::rgb(0x2A2E33, 0.9f), hot ? c.selected : axis.color,
                          1.4f * theme.scale);
        }
    }
    if (editor.session.document().objects.empty()) return; // nothing to frame
    const glm::vec2 square(theme.px(32));
    ui::Rect bar =
        ui::rect_at({middle.x - square.x / 2, middle.y + theme.px(56)}, {square.x, 2 * square.y});
    if (bar.hi.y > view.hi.y - theme.px(8)) // a low picture has room beside the axes
        bar = ui::rect_at({middle.x - theme.px(56) - square.x, middle.y - square.y},
                          {square.x, 2 * square.y});
    // The menu View offers these, too; the labels at the left are nowhere else.
    if (on_card(bar) || bar.lo.x < view.lo.x + theme.px(labels_px)) return;
    ui::paint_box(bar, c.chip, theme.size.rounding_card);
    ui::lower_area("bar", bar);
    ui::Theme on_chip = theme;
    on_chip.color.text = on_chip.color.text_2 = c.chip_text;
    on_chip.color.text_off = ui::faded(c.chip_text, 0.4f);
    on_chip.color.field_hover = ui::faded(c.chip_text, 0.2f);
    const auto button = [&](const char* icon, const char* what, const char* sentence) {
        ImGui::SetCursorScreenPos({bar.lo.x, bar.lo.y});
        const Action& each = action(editor, what);
        if (ui::icon_button(on_chip, what, icon, square, tip_of(editor, each, sentence),
                            {.enabled = is_enabled(editor, each)}))
            each.run(editor);
        bar.lo.y += square.y;
    };
    button(ui::icon::target, "Frame all", "Shows the whole scene.");
    button(ui::icon::camera, "Perspective", "Switches between perspective and orthographic view.");
}

} // namespace trivar
