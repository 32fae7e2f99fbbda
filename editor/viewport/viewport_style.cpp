// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/viewport_style.h"

#include "gpu/look.h"

namespace trivar {

ViewportStyle viewport_style(const ui::Theme& theme, bool as_in_pictures)
{
    const ui::Palette& c = theme.color;
    ViewportStyle style;
    style.outline.color = ui::linear_light(c.selected);
    style.outline.halo = ui::linear_light(c.halo);
    style.outline.width_px = theme.line(style.outline.width_px);
    style.outline.halo_px *= theme.scale;
    style.edge_color = ui::linear_light(ui::rgb(0xE9EBEE)); // of wireframes, in every theme
    style.look = theme.look;
    if (as_in_pictures) return style;
    constexpr float axis_share = 0.55f;
    gpu::Backdrop backdrop;
    backdrop.top = ui::linear_light(c.sky_top);
    backdrop.bottom = ui::linear_light(c.sky_bottom);
    backdrop.middle = glm::mix(backdrop.bottom, backdrop.top, 0.6f);
    backdrop.corners = 0;
    backdrop.line_px = theme.scale;
    backdrop.grid = ui::linear_light(c.grid);
    backdrop.grid_major = ui::linear_light(c.grid_major);
    backdrop.axis_x = ui::linear_light(ui::faded(c.axis_x, axis_share));
    backdrop.axis_y = ui::linear_light(ui::faded(c.axis_y, axis_share));
    backdrop.axis_z = ui::linear_light(ui::faded(c.axis_z, axis_share));
    style.backdrop = backdrop;
    return style;
}

ui::Theme theme_over_picture(const ui::Theme& theme, const RenderSettings& settings,
                             bool as_in_pictures)
{
    ui::Look look = theme.look;
    look.light = !gpu::is_dark(settings.look) && (as_in_pictures || theme.look.light);
    if (look.light == theme.look.light) return theme;
    ui::Theme over = theme;
    over.color = ui::with_overlays(theme.color, look);
    return over;
}

} // namespace trivar
