// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/manual.h"

#include "editor/actions/show_manual.h"
#include "editor/actions/words_with_keys.h"
#include "editor/panels/help/key_lines.h"
#include "editor/panels/panels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// Draws a page from top to bottom at the cursor of a child window.
struct PageView {
    Editor& editor;
    const ui::Theme& theme;
    float left, width, y;
    std::string clicked = {}; // target of a link

    ui::RichStyle style(bool heading = false) const
    {
        const ui::Palette& c = theme.color;
        return {heading ? theme.font.strong : theme.font.body, theme.font.strong,
                heading ? c.text : c.text_2, c.text, theme.px(22)};
    }
    void rich(const std::vector<ui::Run>& runs, float indent = 0, bool heading = false)
    {
        ImGui::PushID(static_cast<int>(y - ImGui::GetWindowPos().y + ImGui::GetScrollY()));
        const ui::DrawnText drawn =
            ui::draw_rich(theme, style(heading), with_keys(editor, runs),
                          {std::round(left + indent), std::round(y)}, width - indent);
        ImGui::PopID();
        if (!drawn.clicked.empty()) clicked = drawn.clicked;
        y += drawn.height;
    }

    void heading(const Block& block)
    {
        y += theme.px(14);
        rich(block.runs, 0, true);
        y += theme.px(2);
    }
    void item(const Block& block)
    {
        const float indent = theme.px(20) * static_cast<float>(std::max(1, block.level));
        const std::string mark = block.number > 0 ? std::to_string(block.number) + "." : "•";
        ui::paint_text(theme.font.body,
                       {{left + indent - theme.px(18), y}, {left + indent, y + theme.px(22)}},
                       theme.color.text_3, mark);
        rich(block.runs, indent);
        y += theme.px(2);
    }
    // The first column is the widest where there are two or more.
    void row(const Block& block)
    {
        const std::size_t count = block.cells.size();
        const float first = std::round(width * (count < 2 ? 1 : count == 2 ? 0.4f : 0.38f));
        const float other = count < 2 ? 0 : (width - first) / static_cast<float>(count - 1);
        const float top = y + theme.px(4), gap = theme.px(12), page = width, edge = left;
        float bottom = top;
        for (std::size_t i = 0; i < count; ++i) {
            const float x = i == 0 ? 0 : first + other * static_cast<float>(i - 1);
            left = edge + x;
            width = (i == 0 ? first : other) - gap;
            y = top;
            ImGui::PushID(static_cast<int>(i));
            rich(block.cells[i], 0, block.header);
            ImGui::PopID();
            bottom = std::max(bottom, y);
        }
        left = edge;
        width = page;
        y = std::max(bottom, top + theme.px(22)) + theme.px(4);
        line();
    }
    void line()
    {
        ui::paint_box({{left, y}, {left + width, y + theme.size.hairline}}, theme.color.line_soft);
        y += theme.size.hairline;
    }
    void picture(const Block& block)
    {
        const float wide = std::min(width, theme.px(480));
        const int px = static_cast<int>(wide);
        const float high =
            std::round(wide / static_cast<float>(editor.stored_pictures.shape(block.text, px)));
        const ui::Rect r = ui::rect_at({left, y + theme.px(6)}, {wide, high});
        paint_picture(editor, theme, r, block.text);
        y = r.hi.y + theme.px(4);
        ui::paint_text(theme.font.small, {{left, y}, {left + width, y + theme.px(20)}},
                       theme.color.text_3,
                       ui::elided(theme.font.small, plain_text(block.runs), width));
        y += theme.px(26);
    }
    void code(const Block& block)
    {
        std::vector<std::string> lines;
        for (std::string_view rest = block.text; !rest.empty();) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            lines.emplace_back(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        const float line = theme.px(18), pad = theme.px(8);
        const ui::Rect r = ui::rect_at({left, y + theme.px(4)},
                                       {width, line * static_cast<float>(lines.size()) + 2 * pad});
        ui::paint_box(r, theme.color.field, theme.size.rounding);
        float at = r.lo.y + pad;
        for (const std::string& words : lines) {
            ui::paint_text(theme.font.mono, {{r.lo.x + pad, at}, {r.hi.x, at + line}},
                           theme.color.text,
                           ui::elided(theme.font.mono, words, r.width() - 2 * pad));
            at += line;
        }
        y = r.hi.y + theme.px(10);
    }
    void draw(const Block& block)
    {
        switch (block.kind) {
        case Block::Kind::heading: return heading(block);
        case Block::Kind::item: return item(block);
        case Block::Kind::row: return row(block);
        case Block::Kind::picture: return picture(block);
        case Block::Kind::code: return code(block);
        case Block::Kind::paragraph: rich(block.runs); y += theme.px(8);
        }
    }
    void draw_keys()
    {
        for (const KeyLine& each : key_lines(editor)) {
            const bool heading = each.how.empty();
            if (heading) y += theme.px(10);
            const ui::Rect row = ui::rect_at({left, y}, {width, theme.px(24)});
            ui::paint_text(heading ? theme.font.strong : theme.font.body, row,
                           heading ? theme.color.text : theme.color.text_2, each.what);
            ui::paint_text(theme.font.body, row, theme.color.text, each.how, ui::Align::right);
            y = row.hi.y;
        }
    }
};

void draw_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r, const ManualPage& page)
{
    auto& dialog = editor.memory.of<ManualDialog>();
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild(page.name.c_str(), {r.width(), r.height()});
    const float top = ImGui::GetCursorScreenPos().y, pad = theme.px(24);
    PageView view{editor, theme, r.lo.x + pad, std::min(r.width() - 2 * pad, theme.px(620)),
                  top + theme.px(20)};
    ui::paint_text(theme.font.title, ui::rect_at({view.left, view.y}, {view.width, theme.px(24)}),
                   theme.color.text, page.title);
    view.y += theme.px(36);
    for (std::size_t i = 0; i < page.blocks.size(); ++i) {
        if (dialog.show_block == i && i > 0) ImGui::SetScrollY(view.y - top - theme.px(12));
        // After a table or a list a little room.
        const auto listed = [](const Block& block) {
            return block.kind == Block::Kind::row || block.kind == Block::Kind::item;
        };
        if (i > 0 && listed(page.blocks[i - 1]) && !listed(page.blocks[i])) view.y += theme.px(8);
        view.draw(page.blocks[i]);
    }
    dialog.show_block.reset();
    if (page.name == keys_page) view.draw_keys();
    ImGui::SetCursorScreenPos({r.lo.x, top});
    ImGui::Dummy({1, view.y - top + theme.px(24)});
    ImGui::EndChild();
    ImGui::PopStyleVar();
    const std::string to = linked_page(view.clicked);
    if (!page_of(editor.memory.of<ManualPages>().pages, to)) return;
    dialog.before.push_back(page.name);
    show_manual(editor, to);
}

// A page in the list, or where something was found; whether it was clicked.
bool list_row(const ui::Theme& theme, const ui::Rect& row, const std::string& title,
              const std::string& words, bool on)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    const bool clicked = ImGui::InvisibleButton("row", {row.width(), row.height()});
    if (on || ImGui::IsItemHovered())
        ui::paint_box(row, on ? c.row_selected : c.row_hover, theme.size.rounding);
    const float left = row.lo.x + theme.px(12), room = row.width() - theme.px(20);
    const ui::Rect first = {{left, row.lo.y}, {row.hi.x, row.lo.y + theme.px(30)}};
    ui::paint_text(on ? theme.font.strong : theme.font.body, first, on ? c.text : c.text_2, title);
    if (!words.empty())
        ui::paint_text(theme.font.small,
                       {{left, row.lo.y + theme.px(24)}, {row.hi.x, row.hi.y - theme.px(2)}},
                       on ? c.text_2 : c.text_3, ui::elided(theme.font.small, words, room));
    return clicked;
}

void draw_list(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    auto& dialog = editor.memory.of<ManualDialog>();
    ImGui::SetCursorScreenPos({r.lo.x + theme.px(12), r.lo.y + theme.px(12)});
    ui::text_field(theme, "search", dialog.search, "Search the manual", r.width() - theme.px(24),
                   ui::icon::search);
    float y = r.lo.y + theme.px(46);
    std::vector<FoundPassage> rows;
    if (dialog.search.find_first_not_of(' ') != std::string::npos)
        rows = found_in(editor.memory.of<ManualPages>().pages, dialog.search);
    else
        for (const ManualPage& page : editor.memory.of<ManualPages>().pages)
            rows.push_back({page.name, {}, 0});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ManualPage& page = *page_of(editor.memory.of<ManualPages>().pages, rows[i].page);
        const bool words = !rows[i].words.empty() && rows[i].words != page.title;
        const ui::Rect row = {{r.lo.x + theme.px(12), y},
                              {r.hi.x - theme.px(12), y + theme.px(words ? 44 : 30)}};
        y = row.hi.y + theme.px(2);
        ImGui::PushID(static_cast<int>(i));
        if (list_row(theme, row, page.title, words ? rows[i].words : "", page.name == dialog.page))
            show_manual(editor, page.name, rows[i].block);
        ImGui::PopID();
    }
    if (rows.empty())
        ui::paint_text(theme.font.small, {{r.lo.x + theme.px(24), y}, {r.hi.x, y + theme.px(24)}},
                       theme.color.text_3, "No page has these words");
}

} // namespace

void paint_picture(Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                   const std::string& path)
{
    const gpu::Texture2D* texture =
        editor.stored_pictures.of(path, static_cast<int>(std::round(r.width())));
    if (!texture) {
        ui::paint_box(r, theme.color.field, theme.size.rounding);
        return;
    }
    // Crops the picture to the shape of its place.
    const glm::vec2 size(texture->size_px());
    const float want = r.width() / r.height(), have = size.x / size.y;
    const glm::vec2 cut =
        have > want ? glm::vec2((1 - want / have) / 2, 0) : glm::vec2(0, (1 - have / want) / 2);
    const auto name = static_cast<std::uintptr_t>(texture->name());
    ImGui::GetWindowDrawList()->AddImageRounded(
        reinterpret_cast<ImTextureID>(name), {r.lo.x, r.lo.y}, {r.hi.x, r.hi.y}, {cut.x, cut.y},
        {1 - cut.x, 1 - cut.y}, 0xFFFFFFFFu, theme.size.rounding);
}

void draw_manual(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.memory.of<ManualDialog>();
    if (!dialog.open) return;
    const ui::Palette& c = theme.color;
    const ui::Rect r = ui::begin_dialog(theme, "manual", {theme.px(920), theme.px(680)});
    const float head = theme.px(56), left = theme.px(232), pad = theme.px(24);
    ui::paint_text(theme.font.title, {r.lo + glm::vec2(pad, 0), {r.hi.x, r.lo.y + head}}, c.text,
                   "Manual");
    const glm::vec2 square(theme.px(32));
    const float button = r.lo.y + (head - square.y) / 2;
    if (!dialog.before.empty()) {
        ImGui::SetCursorScreenPos({r.lo.x + left + theme.px(12), button});
        if (ui::icon_button(theme, "back", ui::icon::undo, square, {"The page before"})) {
            const std::string before = dialog.before.back();
            dialog.before.pop_back();
            show_manual(editor, before);
        }
    }
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(12) - square.x, button});
    const bool close =
        ui::icon_button(theme, "close", ui::icon::close, square, {"Close the manual", "Esc"});
    ui::paint_box({{r.lo.x, r.lo.y + head}, {r.hi.x, r.lo.y + head + theme.size.hairline}},
                  c.line_soft);
    const float y0 = r.lo.y + head + theme.size.hairline;
    draw_list(editor, theme, {{r.lo.x, y0}, {r.lo.x + left, r.hi.y}});
    ui::paint_box({{r.lo.x + left - theme.size.hairline, y0}, {r.lo.x + left, r.hi.y}},
                  c.line_soft);
    draw_page(editor, theme, {{r.lo.x + left, y0}, r.hi - glm::vec2(theme.px(8), theme.px(8))},
              *page_of(editor.memory.of<ManualPages>().pages, std::string(dialog.page)));
    if (close || ImGui::IsKeyPressed(ui::key_escape, false)) {
        dialog = {};
        ImGui::CloseCurrentPopup();
    }
    ui::end_dialog();
}

} // namespace trivar
