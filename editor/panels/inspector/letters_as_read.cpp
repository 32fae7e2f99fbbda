// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/letters_as_read.h"

#include "ui/paint.h"

#include <algorithm>
#include <cstdint>
#include <imgui.h>
#include <map>

namespace trivar {
namespace {

constexpr std::size_t most_faces = 60000; // a frame draws in a millisecond or two

bool is_front(const Mesh& mesh, std::size_t face)
{
    const std::uint32_t* c = &mesh.corners[mesh.face_begin[face]];
    const auto p = [&](int k) { return mesh.positions[c[k]]; };
    const glm::vec3 normal = glm::cross(p(1) - p(0), p(2) - p(0));
    return normal.z > 0.05f * glm::length(normal);
}

} // namespace

LetterFronts letter_fronts(const Mesh& mesh)
{
    LetterFronts out;
    using Edge = std::pair<std::uint32_t, std::uint32_t>; // points of the surface
    std::map<Edge, std::array<glm::vec2, 2>> open;        // met from one side
    for (std::size_t f = 0; f < mesh.face_count() && mesh.face_count() <= most_faces; ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        if (end - begin < 3 || !is_front(mesh, f)) continue;
        const auto corner = [&](std::uint32_t c) { return mesh.corners[c]; };
        const auto flat = [&](std::uint32_t c) { return glm::vec2(mesh.positions[corner(c)]); };
        for (std::uint32_t c = begin + 1; c + 1 < end; ++c)
            out.triangles.push_back({flat(begin), flat(c), flat(c + 1)});
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t next = c + 1 < end ? c + 1 : begin;
            const Edge edge{mesh.point(corner(c)), mesh.point(corner(next))};
            if (open.erase({edge.second, edge.first}) == 0) open[edge] = {flat(c), flat(next)};
        }
    }
    for (const auto& [edge, ends] : open) out.rim.push_back(ends);
    if (out.triangles.empty()) return out;
    out.lo = out.hi = out.triangles.front().front();
    for (const auto& triangle : out.triangles)
        for (const glm::vec2& p : triangle) {
            out.lo = glm::min(out.lo, p);
            out.hi = glm::max(out.hi, p);
        }
    return out;
}

bool field_shows(std::string_view text)
{
    // Hebrew begins at U+0590; before it all is left to right. In UTF-8 the bytes that begin what
    // comes after that are D6 90 and more, but for Latin with two accents and signs, E1 B8 to E2.
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        if (byte < 0xC0 || byte < 0xD6 || (byte == 0xD6 && next < 0x90)) continue;
        const bool latin_or_sign = (byte == 0xE1 && next >= 0xB8) || byte == 0xE2;
        if (!latin_or_sign) return false;
    }
    return true;
}

void draw_letters_as_read(const ui::Theme& theme, const Mesh& text, double em)
{
    const LetterFronts fronts = letter_fronts(text);
    const glm::vec2 size = fronts.hi - fronts.lo;
    if (!(size.x > 0 && size.y > 0)) return;
    const float pad = theme.px(8), most = theme.px(96), letter = theme.px(24);
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    const float scale = std::min(
        {(width - 2 * pad) / size.x, (most - 2 * pad) / size.y, letter / static_cast<float>(em)});
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const ui::Rect box = ui::rect_at({ImGui::GetWindowPos().x + theme.size.padding, cursor.y},
                                     {width, std::ceil(size.y * scale + 2 * pad)});
    ImGui::SetCursorScreenPos({box.lo.x, box.lo.y});
    ImGui::Dummy({box.width(), box.height()});
    ui::tooltip({"As it reads",
                 {},
                 "The letters as they stand in the scene. The field has them in the order in which "
                 "they are typed."});
    ui::paint_rim(box, theme.color.line_soft, theme.size.rounding_small, theme.size.hairline);
    const glm::vec2 middle = box.center(), of = (fronts.lo + fronts.hi) / 2.0f;
    const auto at = [&](const glm::vec2& p) {
        return ImVec2(middle.x + (p.x - of.x) * scale, middle.y - (p.y - of.y) * scale);
    };
    // Smooth outside; inside, triangles that are each smooth would show their edges.
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImDrawListFlags flags = draw.Flags;
    draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (const auto& [a, b, c] : fronts.triangles)
        draw.AddTriangleFilled(at(a), at(b), at(c), theme.color.text);
    draw.Flags = flags;
    for (const auto& [a, b] : fronts.rim)
        draw.AddLine(at(a), at(b), ui::faded(theme.color.text, 0.5f), 1);
    ui::gap(theme, 6);
}

} // namespace trivar
