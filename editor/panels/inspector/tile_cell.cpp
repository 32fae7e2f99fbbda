// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/tile_cell.h"

#include "core/patches/tile_set.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// At scale 1: the height of both views together, the room round the tile, and from how near a line
// is taken and snaps.
constexpr float most_top = 150, most_side = 90, line_reach = 8, snap_px = 5;
// The margin shown round the tile, as a share of its longer side.
constexpr double room_round = 0.15;
constexpr std::size_t most_drawn = 6000; // triangles
constexpr double thinnest_cell = 0.01;

enum class CellLine { none, x0, x1, y0, y1, level };

// The tile as triangles in shares of its box.
struct DrawnTile {
    struct Face {
        std::array<glm::vec3, 3> p;
        glm::vec3 normal;
    };
    std::vector<Face> faces;
    glm::dvec3 size{1}; // of the box, in any unit
};

// `turned` is the layer's own rotation and scale. In their cells tiles may be stretched across.
DrawnTile drawn_tile(const EvaluatedObject& layer, const glm::dmat4& turned)
{
    DrawnTile out;
    Box box;
    std::vector<Ref<Mesh>> meshes;
    Ref<PlacedTiles> places; // of the first kind; its parts have them in common
    for (const Part& part : layer.parts) {
        if (!part.tiles || (places && part.tiles->tiles != places)) continue;
        places = part.tiles->tiles;
        const auto& levels = *part.tiles->model->levels;
        const auto fine = std::ranges::find_if(
            levels, [](const TileLevel& level) { return level.mesh->face_count() <= most_drawn; });
        meshes.push_back(fine != levels.end() ? fine->mesh : levels.back().mesh);
        box.add(part.tiles->model->box);
    }
    const glm::dvec3 in_cell = box.empty() ? glm::dvec3(1) : glm::max(box.size(), glm::dvec3(1e-9));
    Box own;
    for (const Shape::NodeMesh& each : layer.shape->meshes)
        own.add(bounding_box(*each.rest, turned * each.to_model));
    out.size = own.empty() ? in_cell : own.size();
    out.size = glm::max(out.size, 1e-6 * glm::max(out.size.x, glm::max(out.size.y, out.size.z)));
    for (const Ref<Mesh>& mesh : meshes)
        for (const glm::uvec3& t : triangles(*mesh)) {
            DrawnTile::Face face;
            for (int k = 0; k < 3; ++k)
                face.p[static_cast<std::size_t>(k)] =
                    glm::vec3((glm::dvec3(mesh->positions[t[k]]) - box.lo) / in_cell);
            const glm::vec3 scale(out.size),
                n = glm::cross((face.p[1] - face.p[0]) * scale, (face.p[2] - face.p[0]) * scale);
            const float length = glm::length(n);
            if (!(length > 0)) continue;
            face.normal = n / length;
            out.faces.push_back(face);
        }
    return out;
}

// One view: x goes to the right, and y, or z for a side view, up.
struct CellView {
    ui::Rect rect;
    bool side = false;
    glm::vec2 origin{0}; // pixels of the lower left corner of the tile's box
    glm::vec2 scale{1};  // pixels per share of the box

    glm::vec2 seen(double x, double up) const
    {
        return {origin.x + static_cast<float>(x) * scale.x,
                origin.y - static_cast<float>(up) * scale.y};
    }
};

ui::Color mixed_color(ui::Color a, ui::Color b, float share)
{
    const ImVec4 x = ImGui::ColorConvertU32ToFloat4(a), y = ImGui::ColorConvertU32ToFloat4(b);
    return ImGui::ColorConvertFloat4ToU32(
        {glm::mix(x.x, y.x, share), glm::mix(x.y, y.y, share), glm::mix(x.z, y.z, share), 1});
}

void paint_tile(const ui::Theme& theme, const CellView& view, const DrawnTile& tile)
{
    const glm::vec3 toward = view.side ? glm::vec3(0, -1, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 light = glm::normalize(toward + glm::vec3(-0.5f, view.side ? 0 : 0.5f, 0.4f));
    std::vector<const DrawnTile::Face*> order;
    for (const DrawnTile::Face& face : tile.faces)
        if (glm::dot(face.normal, toward) > 0) order.push_back(&face);
    if (order.empty()) // a tile of no thickness, seen from behind or edge-on
        for (const DrawnTile::Face& face : tile.faces) order.push_back(&face);
    const auto depth = [&](const DrawnTile::Face* face) {
        return glm::dot(face->p[0] + face->p[1] + face->p[2], toward);
    };
    std::ranges::stable_sort(order, {}, depth);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImDrawListFlags before = draw.Flags;
    draw.Flags &= ~ImDrawListFlags_AntiAliasedFill; // triangles meet without seams
    for (const DrawnTile::Face* face : order) {
        std::array<glm::vec2, 3> at;
        for (std::size_t k = 0; k < 3; ++k)
            at[k] = view.seen(face->p[k].x, view.side ? face->p[k].z : face->p[k].y);
        const float lit = 0.25f + 0.65f * std::abs(glm::dot(face->normal, light));
        draw.AddTriangleFilled({at[0].x, at[0].y}, {at[1].x, at[1].y}, {at[2].x, at[2].y},
                               mixed_color(theme.color.base, theme.color.text, lit));
    }
    draw.Flags = before;
}

// The line of a view that is near a point.
CellLine line_near(const CellView& view, const TileLook& look, glm::vec2 mouse, float reach)
{
    CellLine found = CellLine::none;
    const auto offer = [&](CellLine line, float distance) {
        if (distance < reach) reach = distance, found = line;
    };
    if (view.side)
        offer(CellLine::level, std::abs(mouse.y - view.seen(0, look.base_level).y));
    else {
        offer(CellLine::y0, std::abs(mouse.y - view.seen(0, look.cell_y0).y));
        offer(CellLine::y1, std::abs(mouse.y - view.seen(0, look.cell_y1).y));
    }
    offer(CellLine::x0, std::abs(mouse.x - view.seen(look.cell_x0, 0).x));
    offer(CellLine::x1, std::abs(mouse.x - view.seen(look.cell_x1, 0).x));
    return found;
}

double& value_of(TileLook& look, CellLine line)
{
    switch (line) {
    case CellLine::x0: return look.cell_x0;
    case CellLine::x1: return look.cell_x1;
    case CellLine::y0: return look.cell_y0;
    case CellLine::y1: return look.cell_y1;
    default: return look.base_level;
    }
}

void drag_line(const CellView& view, TileLook& look, CellLine line, glm::vec2 mouse, float snap)
{
    const bool along = line == CellLine::x0 || line == CellLine::x1;
    const double share =
        along ? (mouse.x - view.origin.x) / view.scale.x : (view.origin.y - mouse.y) / view.scale.y;
    const double per_px = 1.0 / (along ? view.scale.x : view.scale.y);
    double to = std::round(share * 1e3) / 1e3; // values that people can read
    for (const double side : {0.0, 0.5, 1.0})
        if (std::abs(share - side) < snap * per_px) to = side;
    if (line == CellLine::x0) to = std::min(to, look.cell_x1 - thinnest_cell);
    if (line == CellLine::x1) to = std::max(to, look.cell_x0 + thinnest_cell);
    if (line == CellLine::y0) to = std::min(to, look.cell_y1 - thinnest_cell);
    if (line == CellLine::y1) to = std::max(to, look.cell_y0 + thinnest_cell);
    value_of(look, line) = std::clamp(to, -10.0, 10.0);
}

void paint_lines(const ui::Theme& theme, const CellView& view, const TileLook& look, CellLine lit)
{
    const ui::Palette& c = theme.color;
    const auto line = [&](CellLine which, glm::vec2 a, glm::vec2 b) {
        ui::paint_line(a, b, c.halo, theme.line(3));
        ui::paint_line(a, b,
                       which == lit               ? c.selected
                       : which == CellLine::level ? c.contact
                                                  : c.stroke,
                       theme.line(1.6f));
    };
    const ui::Rect& r = view.rect;
    const float x0 = view.seen(look.cell_x0, 0).x, x1 = view.seen(look.cell_x1, 0).x;
    if (look.overlap > 0) { // the part that other tiles of a strand reach over
        const double whole = look.cell_x1 - look.cell_x0,
                     over = whole * (1 - 1 / (1 + 2 * look.overlap)) / 2;
        for (const double x : {look.cell_x0 + over, look.cell_x1 - over}) {
            const float at = view.seen(x, 0).x;
            ui::paint_line({at, r.lo.y}, {at, r.hi.y}, ui::faded(c.stroke, 0.5f), theme.line(1.2f));
        }
    }
    line(CellLine::x0, {x0, r.lo.y}, {x0, r.hi.y});
    line(CellLine::x1, {x1, r.lo.y}, {x1, r.hi.y});
    if (view.side) {
        const float z = view.seen(0, look.base_level).y;
        line(CellLine::level, {r.lo.x, z}, {r.hi.x, z});
        return;
    }
    for (const CellLine which : {CellLine::y0, CellLine::y1}) {
        const double y_share = which == CellLine::y0 ? look.cell_y0 : look.cell_y1;
        const float y = view.seen(0, y_share).y;
        line(which, {r.lo.x, y}, {r.hi.x, y});
    }
}

// Words at the foot of a view, on ground of their own: no line strikes them through.
void paint_words(const ui::Theme& theme, const ui::Rect& foot, ui::Color color,
                 const std::string& words, bool right)
{
    const float width = ui::text_width(theme.font.small, words), air = theme.px(3);
    ui::Rect ground = foot;
    (right ? ground.lo.x : ground.hi.x) = right ? foot.hi.x - width : foot.lo.x + width;
    ground.lo.x -= air;
    ground.hi.x += air;
    ui::paint_box(ground, theme.color.base, theme.size.rounding_small);
    ui::paint_text(theme.font.small, foot, color, words,
                   right ? ui::Align::right : ui::Align::left);
}

// One view with its lines under the mouse.
ui::Edit cell_view(const ui::Theme& theme, const CellView& view, const DrawnTile& tile,
                   TileLook& look, const char* id)
{
    ImGui::SetCursorScreenPos({view.rect.lo.x, view.rect.lo.y});
    ImGui::InvisibleButton(id, {view.rect.width(), view.rect.height()});
    const bool active = ImGui::IsItemActive();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const glm::vec2 mouse(pointer.x, pointer.y);
    int* held = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID(id), 0);
    CellLine lit = CellLine::none;
    if (active && !ImGui::IsItemActivated())
        lit = static_cast<CellLine>(*held);
    else if (active || ImGui::IsItemHovered())
        lit = line_near(view, look, mouse, theme.px(line_reach));
    *held = static_cast<int>(lit);
    ui::Edit edit = ui::Edit::none;
    if (active && lit != CellLine::none && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        const double before = value_of(look, lit);
        drag_line(view, look, lit, mouse, theme.px(snap_px));
        if (value_of(look, lit) != before) edit = ui::Edit::changed;
    }
    if (lit == CellLine::x0 || lit == CellLine::x1)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    else if (lit != CellLine::none)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    ui::paint_box(view.rect, theme.color.base, theme.size.rounding_small);
    ImGui::PushClipRect({view.rect.lo.x, view.rect.lo.y}, {view.rect.hi.x, view.rect.hi.y}, true);
    paint_tile(theme, view, tile);
    paint_lines(theme, view, look, lit);
    const ui::Rect foot{{view.rect.lo.x + theme.px(6), view.rect.hi.y - theme.px(18)},
                        {view.rect.hi.x - theme.px(6), view.rect.hi.y - theme.px(2)}};
    paint_words(theme, foot, theme.color.text_3, view.side ? "Side" : "Top", false);
    if (lit != CellLine::none)
        paint_words(theme, foot, theme.color.text,
                    fmt::format("{} %", ui::short_number(100 * value_of(look, lit))), true);
    ImGui::PopClipRect();
    return edit;
}

} // namespace

ui::Edit draw_tile_cell(const Session& session, const ui::Theme& theme, Id layer, TileLook& look)
{
    const auto found = session.evaluated().objects.find(layer);
    if (found == session.evaluated().objects.end()) return ui::Edit::none;
    const auto there = session.document().objects.find(layer);
    if (there == session.document().objects.end()) return ui::Edit::none;
    const DrawnTile tile =
        drawn_tile(*found->second, glm::dmat4(glm::dmat3(there->second->transform.matrix())));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x + theme.size.padding,
                width = ImGui::GetContentRegionAvail().x - (left - at.x) - theme.size.padding;
    const double round = room_round * std::max({tile.size.x, tile.size.y, tile.size.z});
    // Pixels per unit, the same in both views: what is narrowest decides.
    const float fit = static_cast<float>(
        std::min({width / (tile.size.x + 2 * round), theme.px(most_top) / (tile.size.y + 2 * round),
                  theme.px(most_side) / (tile.size.z + 2 * round)}));
    const float middle = left + width / 2, gap = theme.px(4);
    ui::Edit edit = ui::Edit::none;
    float y = at.y;
    for (const bool side : {false, true}) {
        const double up = side ? tile.size.z : tile.size.y;
        const float height = fit * static_cast<float>(up + 2 * round);
        CellView view{ui::rect_at({left, y}, {width, height}), side};
        view.scale = {fit * static_cast<float>(tile.size.x), fit * static_cast<float>(up)};
        view.origin = {middle - view.scale.x / 2, y + height - fit * static_cast<float>(round)};
        const ui::Edit one = cell_view(theme, view, tile, look, side ? "cell side" : "cell top");
        if (one != ui::Edit::none) edit = one;
        y += height + gap;
    }
    ImGui::SetCursorScreenPos({at.x, y});
    ImGui::Dummy({1, 0});
    return edit;
}

} // namespace trivar
