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
    c.letter_x = c.axis_x;
    c.letter_y = c.axis_y;
    c.letter_z = c.axis_z;

    c.selected = rgb(0xFFFFFF);
    c.hovered = rgb(0xFFFFFF, 0.55f);
    c.lattice = rgb(0x4FD6EE);
    c.lattice_fill = rgb(0x4FD6EE, 0.07f);
    c.stroke = rgb(0xFFB224);
    c.stroke_fill = rgb(0xFFB224, 0.20f);
    c.contact = rgb(0x43CF96);
    c.free_node = rgb(0xFFFFFF);
    c.sphere = rgb(0xE03AA8);
    c.incision = rgb(0xFF7A4D);
    c.fold = rgb(0xC8102E);
    c.path = rgb(0xFFF29A);
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
    c.letter_x = rgb(0xB3261E);
    c.letter_y = rgb(0x3A6B10);
    c.letter_z = rgb(0x1F57BB);
    c.sky_top = rgb(0xC8CCD2);
    c.sky_bottom = rgb(0x9EA4AC);
    c.lattice = rgb(0x1B6F83);
    c.lattice_fill = rgb(0x1B6F83, 0.09f);
    c.stroke = rgb(0x9C5300);
    c.stroke_fill = rgb(0x9C5300, 0.20f);
    c.sphere = rgb(0xA129B5);
    c.incision = rgb(0x721300);
    c.fold = rgb(0x43000E);
    c.path = rgb(0x646A44);
    c.contact = rgb(0x005043);
    c.cpu = rgb(0x2F6FDE);
    c.gpu = rgb(0xB86A00);
    c.chip = rgb(0xF6F7F8, 0.88f);
    c.chip_text = rgb(0x1A1D21);
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

Palette palette_of(const Look& look)
{
    Palette c = look.light ? light_palette() : dark_palette();
    if (look.high_contrast) c.text_2 = c.text_3 = c.text;
    if (!look.other_hues) return c;
    c.lattice = rgb(look.light ? 0x0B0857 : 0x1EFFFF);
    c.stroke = rgb(look.light ? 0xC74A00 : 0xFFC000);
    c.sphere = rgb(look.light ? 0x944BBC : 0x885ED6);
    c.incision = rgb(look.light ? 0x2D001A : 0xCE4F72);
    c.fold = rgb(look.light ? 0x690D00 : 0xD40000);
    c.path = rgb(look.light ? 0x447574 : 0xE4FFA8);
    c.lattice_fill = faded(c.lattice, 0.08f);
    c.stroke_fill = faded(c.stroke, 0.20f);
    return c;
}

Palette with_overlays(Palette palette, const Look& look)
{
    const Palette from = palette_of(look);
    for (const auto field :
         {&Palette::selected, &Palette::hovered, &Palette::lattice, &Palette::lattice_fill,
          &Palette::stroke, &Palette::stroke_fill, &Palette::contact, &Palette::free_node,
          &Palette::halo, &Palette::sphere, &Palette::incision, &Palette::fold, &Palette::path,
          &Palette::sky_top, &Palette::sky_bottom, &Palette::grid, &Palette::grid_major})
        palette.*field = from.*field;
    return palette;
}

double difference(Color a, Color b, Eyes eyes)
{
    // Matrices from linear sRGB to linear sRGB as seen, by rows.
    constexpr double seen[4][3][3] = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{.152286, 1.052583, -.204868},
         {.114503, .786281, .099216},
         {-.003882, -.048116, 1.051998}},
        {{.367322, .860646, -.227968}, {.280085, .672501, .047413}, {-.011820, .042940, .968881}},
        {{1.255528, -.076749, -.178779},
         {-.078411, .930809, .147602},
         {.004733, .691367, .303900}}};
    constexpr double to_xyz[3][3] = {// over the white of D65
                                     {.4124 / .9505, .3576 / .9505, .1805 / .9505},
                                     {.2126, .7152, .0722},
                                     {.0193 / 1.089, .1192 / 1.089, .9505 / 1.089}};
    const auto times = [](const double(&m)[3][3], const glm::dvec3& v) {
        glm::dvec3 result;
        for (int i = 0; i < 3; ++i) result[i] = m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z;
        return result;
    };
    const auto lab = [&](Color color) {
        const glm::dvec3 linear{linear_channel(color, 0), linear_channel(color, 8),
                                linear_channel(color, 16)};
        const glm::dvec3 light = glm::clamp(times(seen[static_cast<int>(eyes)], linear), 0.0, 1.0);
        glm::dvec3 f = times(to_xyz, light);
        for (int i = 0; i < 3; ++i)
            f[i] = f[i] > 0.008856 ? std::cbrt(f[i]) : 7.787 * f[i] + 16.0 / 116;
        return glm::dvec3{116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
    };
    return glm::distance(lab(a), lab(b));
}

glm::vec4 linear_light(Color color)
{
    return {linear_channel(color, 0), linear_channel(color, 8), linear_channel(color, 16),
            static_cast<float>(color >> 24) / 255.0f};
}

} // namespace trivar::ui
