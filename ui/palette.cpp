// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/palette.h"

#include <algorithm>
#include <cmath>

namespace trivar::ui {

Palette dark_palette()
{
    Palette c{};
    c.gap = rgb(0x0E0F11);
    c.base = rgb(0x17191C);
    c.panel = rgb(0x1D2024);
    c.header = rgb(0x22262A);
    c.raised = rgb(0x262A2F);
    c.field = rgb(0x2D3137);
    c.field_hover = rgb(0x363B42);
    c.field_active = rgb(0x15171A);
    c.field_fill = rgb(0x34476A);
    c.raised_rim = rgb(0x40464E);
    c.segment = rgb(0x4B525C);
    c.line = rgb(0x0E0F11);
    c.line_soft = rgb(0x31363C);
    c.scrim = rgb(0x0A0B0C, 0.62f);
    c.row_hover = rgb(0xFFFFFF, 0.05f);
    c.row_selected = rgb(0x2B4672);
    c.row_selected_idle = rgb(0x31363C);

    c.text = rgb(0xE9EBEE);
    c.text_2 = rgb(0xB1B7C0);
    c.text_3 = rgb(0x949BA6);
    c.text_off = rgb(0x646B75);
    c.on_accent = rgb(0xFFFFFF);

    c.accent = rgb(0x2B67D3);
    c.accent_hover = rgb(0x3071E0);
    c.accent_active = rgb(0x2459BA);
    c.accent_text = rgb(0x88B6FF);
    c.focus = rgb(0x6BA4FF);

    c.good = rgb(0x43CF96);
    c.warn = rgb(0xFFB84D);
    c.bad = rgb(0xFF7B6E);
    c.bad_fill = rgb(0xC5372F);
    c.bad_fill_hover = rgb(0xCF4038);
    c.key = rgb(0xFFC24B);
    c.changed = rgb(0x88B6FF);

    c.sky_top = rgb(0x32373D);
    c.sky_bottom = rgb(0x1D2024);
    c.grid = rgb(0xFFFFFF, 0.055f);
    c.grid_major = rgb(0xFFFFFF, 0.12f);
    c.axis_x = rgb(0xF2665F);
    c.axis_y = rgb(0x8CC84B);
    c.axis_z = rgb(0x5B9DFF);

    c.selected = rgb(0xFFFFFF);
    c.hovered = rgb(0xFFFFFF, 0.55f);
    c.lattice = rgb(0x4FD6EE);
    c.lattice_fill = rgb(0x4FD6EE, 0.07f);
    c.stroke = rgb(0xFFB224);
    c.stroke_fill = rgb(0xFFB224, 0.20f);
    c.contact = rgb(0x43CF96);
    c.free_node = rgb(0xFFFFFF);
    c.halo = rgb(0x000000, 0.55f);
    c.chip = rgb(0x0E0F11, 0.80f);
    c.chip_text = rgb(0xE9EBEE);
    c.cpu = rgb(0x6BA4FF);
    c.gpu = rgb(0xFFB224);
    return c;
}

Palette light_palette()
{
    Palette c = dark_palette();
    c.gap = rgb(0xC3C7CD);
    c.base = rgb(0xE9EBEE);
    c.panel = rgb(0xF6F7F8);
    c.header = rgb(0xEEF0F2);
    c.raised = rgb(0xFFFFFF);
    c.field = rgb(0xE3E6EA);
    c.field_hover = rgb(0xD9DDE2);
    c.field_active = rgb(0xFFFFFF);
    c.field_fill = rgb(0xB5CBF2);
    c.raised_rim = rgb(0xC3C7CD);
    c.segment = rgb(0xFFFFFF);
    c.line = rgb(0xC3C7CD);
    c.line_soft = rgb(0xDCE0E5);
    c.scrim = rgb(0x14171B, 0.40f);
    c.row_hover = rgb(0x000000, 0.05f);
    c.row_selected = rgb(0xC9DBFA);
    c.row_selected_idle = rgb(0xDCE0E5);
    c.text = rgb(0x1A1D21);
    c.text_2 = rgb(0x454B54);
    c.text_3 = rgb(0x5C636E);
    c.text_off = rgb(0x949BA6);
    c.accent_text = rgb(0x1F57BB);
    c.focus = rgb(0x2F6FDE);
    c.good = rgb(0x0B7A4B);
    c.warn = rgb(0x8F5A00);
    c.bad = rgb(0xB3261E);
    c.key = rgb(0xB87400);
    c.changed = rgb(0x1F57BB);
    c.sky_top = rgb(0xC8CCD2);
    c.sky_bottom = rgb(0x9EA4AC);
    c.lattice = rgb(0x0A7F9B);
    c.lattice_fill = rgb(0x0A7F9B, 0.09f);
    c.stroke = rgb(0xB86A00);
    c.stroke_fill = rgb(0xB86A00, 0.20f);
    c.grid = rgb(0x000000, 0.07f);
    c.grid_major = rgb(0x000000, 0.14f);
    return c;
}

namespace {

double linear_channel(Color color, int shift)
{
    const double c = ((color >> shift) & 255u) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

} // namespace

Palette with_overlays(Palette palette, bool light_picture)
{
    const Palette from = light_picture ? light_palette() : dark_palette();
    for (const auto field : {&Palette::selected, &Palette::hovered, &Palette::lattice,
                             &Palette::lattice_fill, &Palette::stroke, &Palette::stroke_fill,
                             &Palette::contact, &Palette::free_node, &Palette::halo})
        palette.*field = from.*field;
    return palette;
}

glm::vec4 linear_light(Color color)
{
    return {linear_channel(color, 0), linear_channel(color, 8), linear_channel(color, 16),
            static_cast<float>(color >> 24) / 255.0f};
}

double contrast(Color a, Color b)
{
    const auto luminance = [](Color color) {
        return 0.2126 * linear_channel(color, 0) + 0.7152 * linear_channel(color, 8) +
               0.0722 * linear_channel(color, 16);
    };
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

} // namespace trivar::ui
