// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/paint.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace trivar::ui {
namespace {

ImDrawList& list()
{
    return *ImGui::GetWindowDrawList();
}
ImVec2 v(glm::vec2 p)
{
    return {p.x, p.y};
}

// Half a pixel in, so that a line of odd width covers whole pixels.
Rect inner(const Rect& rect, float thickness)
{
    return rect.grown(-thickness / 2);
}

// Returns the bytes of the whole characters that fit, at least one.
std::size_t bytes_that_fit(const ImFont* font, std::string_view text, float width)
{
    std::size_t fits = 0, end = 0;
    do {
        fits = end;
        do ++end;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u);
    } while (end <= text.size() && text_width(font, text.substr(0, end)) <= width);
    return fits > 0 ? fits : std::min(end, text.size());
}

} // namespace

float text_width(const ImFont* font, std::string_view text)
{
    return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size()).x;
}

void paint_text(const ImFont* font, const Rect& in, Color color, std::string_view text, Align align)
{
    const float spare = in.width() - (align == Align::left ? 0 : text_width(font, text));
    const float shift = align == Align::left ? 0 : align == Align::right ? spare : spare / 2;
    const ImVec2 at{std::round(in.lo.x + shift),
                    std::round(in.lo.y + (in.height() - font->FontSize) / 2)};
    list().AddText(font, font->FontSize, at, color, text.data(), text.data() + text.size());
}

std::string elided(const ImFont* font, std::string text, float width)
{
    if (text_width(font, text) <= width) return text;
    const char* rest = text.data();
    const float room = width - text_width(font, "…");
    if (room > 0)
        font->CalcTextSizeA(font->FontSize, room, 0, text.data(), text.data() + text.size(), &rest);
    text.resize(static_cast<std::size_t>(rest - text.data()));
    return text + "…";
}

std::vector<std::string> wrapped(const ImFont* font, std::string_view text, float width)
{
    std::vector<std::string> lines;
    std::string line;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        std::string word(text.substr(0, end));
        if (text_width(font, word) > width) { // a path: begins a line and is cut where it ends
            if (!line.empty()) lines.push_back(std::exchange(line, {}));
            while (text_width(font, word) > width) {
                const std::size_t fits = bytes_that_fit(font, word, width);
                lines.push_back(word.substr(0, fits));
                word.erase(0, fits);
            }
        }
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string longer = line.empty() ? word : line + " " + word;
        if (text_width(font, longer) <= width || line.empty()) {
            line = longer;
        } else {
            lines.push_back(line);
            line = word;
        }
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

void paint_box(const Rect& rect, Color color, float rounding)
{
    list().AddRectFilled(v(rect.lo), v(rect.hi), color, rounding);
}

void paint_rim(const Rect& rect, Color color, float rounding, float thickness)
{
    const Rect r = inner(rect, thickness);
    list().AddRect(v(r.lo), v(r.hi), color, rounding, 0, thickness);
}

void paint_dot(glm::vec2 center, float radius, Color color, Color rim, float rim_width)
{
    list().AddCircleFilled(v(center), radius, color);
    if (rim_width > 0) list().AddCircle(v(center), radius, rim, 0, rim_width);
}

void paint_ball(glm::vec2 center, float radius, Color color, float rim_width)
{
    // Rings between circles of equal steps of depth, each with the shade of its direction.
    constexpr int sectors = 64, rings = 10;
    const glm::vec3 light = glm::normalize(glm::vec3(-0.45f, -0.6f, 0.66f)); // y down
    const auto shade = [&](float share, float angle) {
        const glm::vec3 n(share * std::cos(angle), share * std::sin(angle),
                          std::sqrt(std::max(0.0f, 1 - share * share)));
        const float lit = std::max(0.0f, glm::dot(n, light)), edge = 1 - n.z;
        const float gleam = std::pow(lit, 24.0f);
        ImVec4 out = ImGui::ColorConvertU32ToFloat4(color);
        for (float* each : {&out.x, &out.y, &out.z}) *each += (1 - *each) * 0.8f * gleam;
        out.w *= 0.14f + 0.34f * edge * edge + 0.12f * lit + 0.4f * gleam;
        return ImGui::ColorConvertFloat4ToU32(out);
    };
    ImDrawList& draw = list();
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    draw.PrimReserve(sectors * rings * 6, (sectors + 1) * (rings + 1));
    const unsigned first = draw._VtxCurrentIdx;
    for (int ring = 0; ring <= rings; ++ring) {
        const float share = std::sin(static_cast<float>(ring) / rings * 1.5707963f);
        for (int sector = 0; sector <= sectors; ++sector) {
            const float angle = static_cast<float>(sector) / sectors * 6.2831853f;
            draw.PrimWriteVtx(
                v(center + radius * share * glm::vec2(std::cos(angle), std::sin(angle))), white,
                shade(share, angle));
        }
    }
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            const unsigned a = first + static_cast<unsigned>(ring * (sectors + 1) + sector),
                           b = a + sectors + 1;
            for (const unsigned i : {a, b, b + 1, a, b + 1, a + 1})
                draw.PrimWriteIdx(static_cast<ImDrawIdx>(i));
        }
    draw.AddCircle(v(center), radius, faded(color, 0.9f), 0, rim_width);
}

void paint_diamond(glm::vec2 center, float radius, Color fill, Color rim, float rim_width)
{
    const ImVec2 up = v(center - glm::vec2(0, radius)), right = v(center + glm::vec2(radius, 0)),
                 down = v(center + glm::vec2(0, radius)), left = v(center - glm::vec2(radius, 0));
    if (fill) list().AddQuadFilled(up, right, down, left, fill);
    if (rim) list().AddQuad(up, right, down, left, rim, rim_width);
}

void paint_line(glm::vec2 a, glm::vec2 b, Color color, float thickness)
{
    list().AddLine(v(a), v(b), color, thickness);
}

void paint_path(const std::vector<glm::vec2>& points, Color color, float thickness, bool closed)
{
    for (const glm::vec2& p : points) list().PathLineTo(v(p));
    list().PathStroke(color, closed ? ImDrawFlags_Closed : 0, thickness);
}

void paint_card(const Theme& theme, const Rect& rect)
{
    const float rounding = theme.size.rounding_card;
    paint_shadow({rect.lo + glm::vec2(0, theme.px(5)), rect.hi + glm::vec2(0, theme.px(5))},
                 rounding, theme.px(22), 0.17f);
    paint_box(rect, theme.color.raised, rounding);
    paint_rim(rect, theme.color.raised_rim, rounding, theme.size.hairline);
}

Rect paint_chip(const Theme& theme, glm::vec2 at, const Chip& chip)
{
    const ImFont* font = theme.font.small;
    const float before = (chip.dot ? theme.px(14) : 0) + (chip.icon ? theme.px(18) : 0);
    const Rect rect =
        rect_at(at, {text_width(font, chip.text) + theme.px(16) + before, theme.size.row});
    paint_box(rect, theme.color.chip, theme.size.rounding);
    float x = rect.lo.x + theme.px(8);
    if (chip.dot) {
        // A dot's colour need not stand out from the chip's.
        paint_dot({x + theme.px(4), rect.center().y}, theme.px(4), chip.dot, theme.color.chip_text,
                  1.2f * theme.scale);
        x += theme.px(14);
    }
    if (chip.icon) {
        const Color color = chip.icon_color ? chip.icon_color : theme.color.chip_text;
        paint_text(font, {{x, rect.lo.y}, rect.hi}, color, chip.icon);
        x += theme.px(18);
    }
    paint_text(font, {{x, rect.lo.y}, rect.hi}, theme.color.chip_text, chip.text);
    return rect;
}

float keycap_width(const Theme& theme, std::string_view text)
{
    return std::max(theme.px(20), text_width(theme.font.small, text) + theme.px(10));
}

float paint_keycap(const Theme& theme, glm::vec2 at, float height, std::string_view text)
{
    const ImFont* font = theme.font.small;
    const float h = theme.px(18), w = keycap_width(theme, text);
    const Rect cap = rect_at({at.x, std::round(at.y + (height - h) / 2)}, {w, h});
    paint_box(cap, theme.color.field, theme.size.rounding_small);
    paint_rim(cap, theme.color.raised_rim, theme.size.rounding_small, theme.size.hairline);
    paint_text(font, cap, theme.color.text, text, Align::center);
    return w;
}

float paint_mouse(const Theme& theme, glm::vec2 at, float height, MouseGlyph glyph)
{
    const Palette& c = theme.color;
    const float w = theme.px(12), h = theme.px(16), split = theme.px(7);
    const float round = 5.5f * theme.scale, line = std::max(1.0f, 1.1f * theme.scale);
    const glm::vec2 lo{at.x, std::round(at.y + (height - h) / 2)}, hi = lo + glm::vec2(w, h);
    const float mid = lo.x + w / 2;
    if (glyph == MouseGlyph::left)
        list().AddRectFilled(v(lo), {mid, lo.y + split}, c.accent_text, round,
                             ImDrawFlags_RoundCornersTopLeft);
    if (glyph == MouseGlyph::right)
        list().AddRectFilled({mid, lo.y}, {hi.x, lo.y + split}, c.accent_text, round,
                             ImDrawFlags_RoundCornersTopRight);
    list().AddRect(v(lo + 0.5f), v(hi - 0.5f), c.text_2, round, 0, line);
    paint_line(lo + glm::vec2(0.5f, split), {hi.x - 0.5f, lo.y + split}, c.text_2, line);
    if (glyph == MouseGlyph::left || glyph == MouseGlyph::right) {
        paint_line({mid, lo.y}, {mid, lo.y + split}, c.text_2, line);
        return w;
    }
    const float half = 1.6f * theme.scale;
    paint_box({{mid - half, lo.y + theme.px(2)}, {mid + half, lo.y + split}}, c.accent_text, half);
    if (glyph == MouseGlyph::middle) return w;
    const float x = at.x + theme.px(17), y = at.y + height / 2, a = theme.px(3);
    list().AddTriangleFilled({x - a, y - theme.px(2)}, {x + a, y - theme.px(2)},
                             {x, y - theme.px(6)}, c.accent_text);
    list().AddTriangleFilled({x - a, y + theme.px(2)}, {x + a, y + theme.px(2)},
                             {x, y + theme.px(6)}, c.accent_text);
    return w + theme.px(8);
}

} // namespace trivar::ui
