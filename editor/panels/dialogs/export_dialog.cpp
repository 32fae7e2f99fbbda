// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/export_wish.h"
#include "editor/panels/dialogs/plan_dialog.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "editor/words/file_words.h"
#include "ui/dialog.h"
#include "ui/keys.h"
#include "ui/sentence.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <imgui.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

void browse(ExportDialog& dialog)
{
    std::vector<std::string> endings = animated_extensions();
    if (const int kind = kind_of(dialog.plan); kind > 0) // a name without one gets the first
        std::rotate(endings.begin(), endings.begin() + kind, endings.begin() + kind + 1);
    const fs::path file(with_long_home(dialog.plan.file));
    dialog.browser.open({.title = "Export frames",
                         .action = "Choose",
                         .extensions = endings,
                         .saving = true,
                         .name = file.filename().string()},
                        file.parent_path());
}

// Whether the dialog asks about instances: a .usda has them, and the scene has something for them.
bool asks_for_instances(const ExportPlan& plan, const Document& document)
{
    return animated_extensions()[static_cast<std::size_t>(std::max(0, kind_of(plan)))] == ".usda" &&
           has_tiles(document);
}

bool draw_plan(const ui::Theme& theme, ExportPlan& plan, const Document& document)
{
    const bool browsed =
        draw_path_row(theme, "File", plan.file, "a file", "Its folder must exist.");
    int kind = kind_of(plan);
    const float width =
        ui::label_row(theme, "Format", false,
                      "A glTF clip, USD, or point caches for 3ds Max and LightWave.")
            .width;
    if (ui::segments(theme, "kinds", kind, {"GLB", "USDA", "PC2", "MDD"}, width) ==
        ui::Edit::changed)
        set_kind(plan, kind);
    draw_frames_row(theme, document.time, plan.first, plan.last, nullptr);
    const bool asks = asks_for_instances(plan, document);
    if (asks) {
        ui::label_row(theme, "Instances", false,
                      "One mesh per tile type, not bent, in place of all tiles. Tiles that this "
                      "would move further than the tolerance stay as they are.");
        ui::check_box(theme, "instances", plan.instances, tiles_as_instances);
    }
    const std::string help = "Largest distance of a GLB, or of an instance, from the scene at any "
                             "time. Auto: 1 mm, or more where it moves too fast for that.";
    if (kind != 0 && !(asks && plan.instances))
        ui::fact_row(theme, "Tolerance", "none: each frame is exact", theme.color.text_3, help);
    else
        ui::number_field(theme, "tolerance", plan.tolerance,
                         {.lo = 0, .hi = 1e3, .unit = "m", .zero = "auto"},
                         ui::label_row(theme, "Tolerance", false, help).width);
    return browsed;
}

} // namespace

void draw_export_dialog(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.memory.of<ExportDialog>();
    if (!dialog.open) return;
    if (dialog.browser.is_open()) {
        if (const auto file = dialog.browser.draw(theme)) dialog.plan.file = with_short_home(*file);
        return;
    }
    bool browsed = false;
    std::optional<ExportWish> wish;
    ExportOutlook outlook;
    const PlanAnswer answer = draw_plan_dialog(
        theme,
        {.title = "Export frames",
         .rows = asks_for_instances(dialog.plan, editor.session.document()) ? 5 : 4,
         .fields = [&] { browsed = draw_plan(theme, dialog.plan, editor.session.document()); },
         .come_to =
             [&] {
                 wish = wish_of(dialog.plan, editor.session);
                 outlook = outlook_of(dialog.plan, *wish);
                 return outlook.words;
             },
         .begin = [&] { return std::string(outlook.replaces ? "Replace" : "Export"); }});
    if (browsed) browse(dialog);
    dialog.open = answer == PlanAnswer::none;
    if (answer == PlanAnswer::begun) editor.frames_export.begin(std::move(*wish));
}

void draw_not_certified(Editor& editor, const ui::Theme& theme)
{
    auto& reading = editor.frames_export.reading;
    if (!reading) return;
    const float foot = theme.px(60), pad = theme.px(24), line = theme.px(20);
    const ui::Rect r = ui::begin_dialog(theme, "not certified", {theme.px(600), theme.px(480)});
    const std::string title = "What is not certified of " + reading->file;
    const float y0 = ui::draw_dialog_head(
        theme, r, ui::elided(theme.font.title, title, r.width() - 2 * pad).c_str());
    const float y1 = r.hi.y - foot;
    ImGui::SetCursorScreenPos({r.lo.x, y0});
    ImGui::BeginChild("sentences", {r.width(), y1 - y0});
    ui::gap(theme, 12);
    std::string all;
    for (const std::string& each : reading->sentences) {
        const std::string words = ui::sentence(each);
        all += words + "\n";
        const auto lines = ui::wrapped(theme.font.body, words, r.width() - 2 * pad);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({1, line * static_cast<float>(lines.size()) + theme.px(4)});
        for (std::size_t i = 0; i < lines.size(); ++i)
            ui::paint_text(theme.font.body,
                           ui::rect_at({r.lo.x + pad, at.y + line * static_cast<float>(i)},
                                       {r.width() - 2 * pad, line}),
                           theme.color.text_2, lines[i]);
    }
    ui::gap(theme, 12);
    ImGui::EndChild();
    ui::paint_box({{r.lo.x, y1}, {r.hi.x, y1 + theme.size.hairline}}, theme.color.line_soft);
    const glm::vec2 size(theme.px(96), theme.px(32));
    const float row = std::round(y1 + (foot - size.y) / 2);
    ImGui::SetCursorScreenPos({r.hi.x - pad - 2 * size.x - theme.px(8), row});
    if (ui::button(theme, "Copy", ui::ButtonKind::plain, size))
        ImGui::SetClipboardText(all.c_str());
    ImGui::SetCursorScreenPos({r.hi.x - pad - size.x, row});
    if (ui::button(theme, "Close", ui::ButtonKind::primary, size) ||
        ImGui::IsKeyPressed(ui::key_escape, false)) {
        ImGui::CloseCurrentPopup();
        reading.reset();
    }
    ui::end_dialog();
}

} // namespace trivar
