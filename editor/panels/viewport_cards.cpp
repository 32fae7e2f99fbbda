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

struct Axis {
    glm::dvec3 direction;
    ui::Color color;
    const char* name; // empty: the negative end
};

} // namespace

void draw_navigation(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const ui::Palette& c = theme.color;
    Camera& camera = editor.session.camera;
    const glm::vec2 middle{view.hi.x - theme.px(56), view.lo.y + theme.px(56)};
    const float reach = theme.px(32);
    ui::paint_dot(middle, theme.px(44), ui::rgb(0x0E0F11, 0.22f));
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
            camera = ui::seen_from(camera, axis.direction);
        const bool hot = ImGui::IsItemHovered();
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
    ui::paint_box(bar, c.chip, theme.size.rounding_card);
    ui::Theme on_chip = theme; // which is dark whatever the panels are
    on_chip.color.text = on_chip.color.text_2 = c.chip_text;
    on_chip.color.text_off = ui::faded(c.chip_text, 0.4f);
    on_chip.color.field_hover = ui::faded(c.chip_text, 0.2f);
    const auto button = [&](const char* icon, const char* what) {
        ImGui::SetCursorScreenPos({bar.lo.x, bar.lo.y});
        const Action& each = action(editor, what);
        if (ui::icon_button(on_chip, what, icon, square, each.name, key_text(each),
                            {.enabled = is_enabled(editor, each)}))
            each.run(editor);
        bar.lo.y += square.y;
    };
    button(ui::icon::target, "Frame all");
    button(ui::icon::camera, "Perspective");
}

void draw_first_steps(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const Session& session = editor.session;
    if (!editor.preferences.hints || editor.active_tool().busy() || session.jobs().status()) return;
    std::size_t shapes = 0;
    for (const auto& [id, each] : session.document().objects) {
        if (each->placement) return; // the first stroke is done
        if (!std::holds_alternative<GroupShape>(each->source)) ++shapes;
    }
    const bool placing = editor.active_tool().name() == "Place";
    const std::string key = key_text(action(editor, "Place"));
    const std::string bold = shapes == 0  ? "Drop a scene here"
                             : shapes < 2 ? "Now drop the model to lay on it"
                             : placing    ? "Draw across the scene"
                                          : (key.empty() ? "Choose Place" : "Press " + key) +
                                             ", then draw across the scene";
    const std::string body = shapes < 2 ? "Or add one from the Add menu."
                             : placing  ? "Keep the left button down; let go to place the model."
                                        : "The model will lie along the stroke.";
    const ImFont* font = theme.font.strong;
    const float text = std::max(ui::text_width(font, bold), ui::text_width(theme.font.body, body));
    const float width = std::min(text + theme.px(104), view.width() - theme.px(24));
    const glm::vec2 size{width, theme.px(64)};
    float left = std::round(view.center().x - width / 2);
    if (!session.notices.all().empty()) { // beside them, or not at all
        const float end = ui::Notices::left_of(theme, view) - theme.px(12);
        left = std::min(left, end - width);
        if (left < view.lo.x + theme.px(12)) return;
    }
    const ui::Rect r = ui::rect_at({left, view.hi.y - size.y - theme.px(16)}, size);
    ui::paint_card(theme, r);
    ui::paint_text(theme.font.large_icon, {r.lo + glm::vec2(theme.px(16), 0), r.hi},
                   theme.color.stroke, ui::icon::place);
    const float x = r.lo.x + theme.px(58);
    ui::paint_text(font, {{x, r.lo.y + theme.px(10)}, {r.hi.x, r.lo.y + theme.px(32)}},
                   theme.color.text, ui::elided(font, bold, width - theme.px(98)));
    ui::paint_text(theme.font.body, {{x, r.lo.y + theme.px(32)}, {r.hi.x, r.lo.y + theme.px(54)}},
                   theme.color.text_2, ui::elided(theme.font.body, body, width - theme.px(98)));
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(34), r.lo.y + theme.px(8)});
    if (ui::icon_button(theme, "silence", ui::icon::close, glm::vec2(theme.size.icon_button),
                        "Show no hints"))
        editor.preferences.hints = false;
}

} // namespace trivar
