// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/source.h"
#include "editor/actions/model_actions.h"
#include "editor/panels/foot_cards.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <set>

namespace trivar {
namespace {

struct TileLibrary {
    bool folded = false;        // only its heading is shown
    int drawn = -1;             // number of the frame in which it was drawn last
    std::set<std::string> gone; // files that were not there when it came to be shown
};

// At scale 1.
constexpr glm::vec2 tile_cell_px{76, 76};
constexpr float most_share = 0.4f; // of the height of the picture
constexpr float cell_gap = 6, pad = 12, heading_px = 34, most_rows = 2, most_columns = 8;

struct LibraryTile {
    std::string name, file;
    const OwnModel* own = nullptr; // null: a file that was dropped
};

bool file_exists(const std::string& file)
{
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

// A disk may be slow, so files are looked for when the library comes to be shown alone.
void look_for_files(TileLibrary& library, const std::vector<std::string>& files)
{
    const int now = ImGui::GetFrameCount();
    const bool stays = library.drawn == now || library.drawn + 1 == now;
    library.drawn = now;
    if (stays) return;
    library.gone.clear();
    for (const std::string& file : files)
        if (!file_exists(file)) library.gone.insert(file);
}

std::string sentence_of_gone(const std::string& file)
{
    return "It was at " + file + "; drop it again from where it is now.";
}

// The library shows the files that were dropped, and the models that are there to be tiles.
std::vector<LibraryTile> library_tiles(const Editor& editor)
{
    std::vector<LibraryTile> tiles;
    for (const std::string& file : editor.preferences.library_tiles)
        tiles.push_back({std::filesystem::path(file).stem().string(), file});
    for (const OwnModel& each : own_models())
        if (each.use == ModelUse::painted)
            tiles.push_back({each.name, file_of(editor.files, each), &each});
    return tiles;
}

void choose_tile(Editor& editor, const LibraryTile& tile, bool also)
{
    if (!tile.own && !file_exists(tile.file)) {
        editor.memory.of<TileLibrary>().gone.insert(tile.file);
        editor.session.notices.say(ui::NoticeKind::warning,
                                   std::filesystem::path(tile.file).filename().string() +
                                       " is missing",
                                   sentence_of_gone(tile.file), {},
                                   {{"Remove from library", [&editor, file = tile.file] {
                                         std::erase(editor.preferences.library_tiles, file);
                                     }}});
        return;
    }
    editor.memory.of<TileLibrary>().gone.erase(tile.file);
    ModelTool& models = *editor.tool_models();
    models.choose_model(editor.session, tile.file, also);
    if (tile.own) models.fit_model(tile.own->fit);
}

// Names the models with which the brush paints, in its order: tiles of the library by their names,
// other models by their files, and else the selection.
std::vector<std::string> painted_with(const Editor& editor, const std::vector<std::string>& files)
{
    std::vector<std::string> names;
    for (const std::string& file : files) {
        const OwnModel* own = own_model_named_as(editor.files, file);
        names.push_back(own ? own->name : std::filesystem::path(file).stem().string());
    }
    const std::string selected = name_of(editor.session.document(), editor.session.selected);
    if (names.empty() && !selected.empty()) names.push_back(selected);
    return names;
}

// Whether another tile can be added to those that the brush paints with.
bool takes_another(const Session& session)
{
    return session.selected == 0 || is_tile_layer(session.document(), session.selected);
}

} // namespace

bool drop_tiles(Editor& editor, const std::vector<std::string>& paths)
{
    const bool paints = editor.tool_models() && !editor.session.document().objects.empty();
    if (!paints || !std::ranges::all_of(paths, is_model)) return false;
    std::vector<std::string> files;
    for (const std::string& path : paths)
        files.push_back(std::filesystem::absolute(path).lexically_normal().string());
    for (std::size_t i = 0; i < files.size(); ++i) choose_tile(editor, {{}, files[i]}, i > 0);
    for (auto file = files.rbegin(); file != files.rend(); ++file)
        remember(editor.preferences.library_tiles, *file);
    return true;
}

std::optional<ui::Rect> draw_tile_library(Editor& editor, const ui::Theme& theme,
                                          const FootCards& foot)
{
    if (!editor.tool_models()) return {};
    const std::vector<std::string> chosen = editor.tool_models()->chosen_models(editor.session);
    auto& library = editor.memory.of<TileLibrary>();
    look_for_files(library, editor.preferences.library_tiles);
    const std::vector<LibraryTile> tiles = library_tiles(editor);
    const ui::Palette& c = theme.color;
    const glm::vec2 size = theme.px(1) * tile_cell_px;
    const float gap = theme.px(cell_gap), edge = theme.px(pad);
    const float room = foot.view().width() - 2 * edge - theme.px(2 * pad);
    const float columns = std::clamp(std::floor((room + gap) / (size.x + gap)), 1.0f, most_columns);
    const float rows = std::ceil(static_cast<float>(tiles.size()) / columns);
    const bool there = !editor.files.own_models_folder.empty();
    const float fit = std::floor((most_share * foot.view().height() - theme.px(heading_px)) /
                                 (size.y + gap)); // rows
    const bool open = there && !library.folded && fit >= 1;
    const float width = columns * (size.x + gap) - gap + 2 * theme.px(pad);
    const float shown = open ? std::min({rows, most_rows, fit}) * (size.y + gap) + theme.px(6) : 0;
    const float left = foot.view().lo.x + edge;
    const ui::Rect view = foot.above(left, left + width);
    const float height = theme.px(heading_px) + shown;
    const ui::Rect card = ui::rect_at({left, view.hi.y - height - edge}, {width, height});
    ui::paint_card(theme, card);
    ui::lower_area("tile library", card); // takes the clicks

    const ui::Rect head = {card.lo + glm::vec2(theme.px(pad), 0),
                           {card.hi.x - theme.px(36), card.lo.y + theme.px(heading_px)}};
    ui::paint_text(theme.font.strong, head, c.text, "Tiles");
    const std::vector<std::string> with = painted_with(editor, chosen);
    const float taken = ui::text_width(theme.font.strong, "Tiles") + theme.px(14);
    const ui::Rect beside = {head.lo + glm::vec2(taken, 0), head.hi};
    const char* more = takes_another(editor.session) ? "; Shift and a click add another" : "";
    ui::name_text(theme.font.small, beside, with.empty() ? c.text_3 : c.text_2,
                  with.empty() ? "Choose one to paint with, or select an object"
                               : fmt::format("Painting with {}{}", fmt::join(with, ", "), more));
    if (!there) return card;
    ImGui::SetCursorScreenPos({card.hi.x - theme.px(32), card.lo.y + theme.px(4)});
    if (ui::icon_button(theme, "fold tiles", open ? ui::icon::open : ui::icon::closed,
                        glm::vec2(theme.px(26)),
                        {open ? "Hide the tile library" : "Show the tile library", {}, {}}))
        library.folded = !library.folded;
    if (!open) return card;

    ImGui::SetCursorScreenPos({head.lo.x, head.hi.y});
    ImGui::BeginChild("tiles", {card.hi.x - head.lo.x, shown});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const auto across = static_cast<std::size_t>(columns);
        const glm::vec2 place(i % across, i / across);
        const ui::Rect r =
            ui::rect_at(glm::vec2(at.x, at.y) + place * (size + glm::vec2(gap)), size);
        const bool now = std::ranges::find(with, tiles[i].name) != with.end();
        const bool clicked = tiles[i].own
                                 ? draw_model(editor, theme, r, *tiles[i].own, now)
                                 : draw_model_cell(editor, theme, r, tiles[i].name, {}, now);
        if (!tiles[i].own && library.gone.contains(tiles[i].file)) {
            ui::tooltip({tiles[i].name + " is missing", {}, sentence_of_gone(tiles[i].file)});
            ui::paint_text(theme.font.body, {r.lo, r.lo + glm::vec2(theme.px(24))}, c.warn,
                           ui::icon::warning, ui::Align::center);
        }
        if (clicked) choose_tile(editor, tiles[i], ImGui::GetIO().KeyShift);
    }
    ImGui::SetCursorScreenPos({at.x, at.y + rows * (size.y + gap)});
    ImGui::Dummy({1, 0});
    ImGui::EndChild();
    return card;
}

} // namespace trivar
