// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/tetrahedra/cloud_room.h"
#include "editor/hands/helpers.h"
#include "editor/hands/points_tool.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/hands/viewport_input.h"
#include "editor/picture/tetrahedra_picture.h"
#include "editor/tools/tetrahedra/tetrahedra_clouds.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Paints how much room clouds have before they would cross.
void paint_room(const ui::Theme& theme, glm::vec2 at, double room)
{
    const double share =
        std::clamp((room - least_room) / (1 - least_room), 0.0, 1.0); // of what can be lost
    const glm::vec2 size{theme.px(120), theme.px(6)};
    const ui::Color color = share > 0.25   ? theme.color.good
                            : share > 0.02 ? theme.color.warn
                                           : theme.color.bad;
    ui::paint_box(ui::rect_at(at, size).grown(theme.scale), theme.color.chip, theme.px(4));
    ui::paint_box(ui::rect_at(at, {std::max(size.x * static_cast<float>(share), size.y), size.y}),
                  color, theme.px(3));
}

} // namespace

Helpers TetrahedraClouds::helpers(const Session& session, const ui::Theme& theme) const
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume || volume->id != object_ || !vertex_) return {};
    if (knot_ == 0) return {.lines = lines(theme)};
    return {lines(theme), {region_veil(theme)}};
}

std::vector<gpu::Line> TetrahedraClouds::lines(const ui::Theme& theme) const
{
    std::vector<gpu::Line> out = cell_lines(domain(), cells_, to_world_,
                                            ui::faded(theme.color.sphere, 0.6f), theme.line(1.4f));
    for (const std::vector<glm::dvec3>& face : region_) {
        gpu::Line rim{{}, ui::linear_light(ui::faded(theme.color.stroke, 0.5f)), theme.line(1)};
        for (std::size_t i = 0; i <= face.size(); ++i)
            rim.points.emplace_back(world(face[i % face.size()]));
        out.push_back(std::move(rim));
    }
    return out;
}

gpu::Translucent TetrahedraClouds::region_veil(const ui::Theme& theme) const
{
    gpu::Translucent out;
    out.colors = {ui::linear_light(ui::faded(theme.color.stroke_fill, 0.6f))};
    for (const std::vector<glm::dvec3>& face : region_) {
        const auto first = static_cast<std::uint32_t>(out.points.size());
        for (const glm::dvec3& p : face) out.points.emplace_back(world(p));
        for (std::uint32_t i = 2; i < face.size(); ++i)
            out.triangles.insert(out.triangles.end(), {first, first + i - 1, first + i});
    }
    return out;
}

void TetrahedraClouds::overlay(const Session& session, const ui::Theme& theme,
                               const ViewportInput& input) const
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume || volume->id != object_) return;
    const auto seen = [&](const glm::dvec3& p) -> std::optional<glm::vec2> {
        const PicturePoint at = project(session.view.camera, world(p));
        if (at.depth_world <= 0) return {};
        return input.rect.lo + glm::vec2(at.p_px);
    };
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    const std::size_t count = domain().vertex_count();
    for (std::size_t v = 0; v < count; ++v) {
        const auto at = seen(domain().vertex(static_cast<int>(v)));
        if (!at) continue;
        const bool lit = hovered_ == static_cast<int>(v), picked = vertex_ == static_cast<int>(v);
        if (!lit && !picked && count > many_handles &&
            glm::distance(*at, mouse) > handles_near_px * input.scale)
            ui::paint_dot(*at, 1.5f * theme.scale, ui::faded(theme.color.focus, 0.6f), 0, 0);
        else
            ui::paint_dot(*at, (lit || picked ? 5.0f : 3.5f) * theme.scale,
                          lit || picked ? theme.color.selected : theme.color.focus,
                          theme.color.halo, 1.25f * theme.scale);
    }
    if (!vertex_) return;
    const auto vertex = seen(at_);
    for (int j = 1; j <= domain().degree; ++j) {
        const auto at = seen(domain().knot(*vertex_, j));
        if (!at || !vertex) continue;
        const bool lit = hovered_knot_ == j || knot_ == j;
        ui::paint_line(*vertex, *at, theme.color.halo, 3 * theme.scale);
        ui::paint_line(*vertex, *at, theme.color.stroke, theme.line(1.3f));
        ui::paint_dot(*at, (lit ? 5.0f : 4.0f) * theme.scale, theme.color.stroke, theme.color.halo,
                      1.25f * theme.scale);
        if (lit) ui::paint_dot(*at, 2 * theme.scale, theme.color.selected, 0, 0);
        const float px = theme.scale;
        const ui::Rect place =
            ui::rect_at(*at + glm::vec2(8 * px, -16 * px), {theme.px(20), theme.px(14)});
        for (const glm::vec2 by : {glm::vec2(px, 0), {-px, 0}, {0, px}, {0, -px}})
            ui::paint_text(theme.font.small_strong, {place.lo + by, place.hi + by},
                           theme.color.halo, std::to_string(j));
        ui::paint_text(theme.font.small_strong, place, theme.color.selected, std::to_string(j));
    }
    if (!gesture_ || !session.proposing()) return;
    const glm::vec2 at = mouse + glm::vec2(theme.px(18), -theme.px(38));
    std::string words = gesture_->kind() == MotionKind::move
                            ? fmt::format("{} m", number_text(glm::length(cloud_.by)))
                            : fmt::format("× {}", number_text(cloud_.factor));
    words += stopped_ ? ", stopped: clouds would cross"
                      : fmt::format("  ·  room {}", percent_text(room_));
    const ui::Rect chip =
        ui::paint_chip(theme, at, {words, stopped_ ? theme.color.bad : ui::Color{0}});
    paint_room(theme, {chip.lo.x + theme.px(4), chip.hi.y + theme.px(5)}, room_);
}

std::vector<Hint> TetrahedraClouds::hints(const Session&) const
{
    if (gesture_) return gesture_.hints("Along an axis");
    if (!vertex_) return {{{"left"}, "Show the knots of a vertex"}, {{"Esc"}, "Select"}};
    return {{{"left"}, "Drag a knot"},
            {{"@Scale"}, "Widen or narrow the cloud"},
            {{"left"}, "Another vertex"},
            {{"Esc"}, "Select"}};
}

} // namespace trivar
