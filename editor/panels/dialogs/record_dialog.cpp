// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/actions/file_actions.h"
#include "editor/panels/dialogs/plan_dialog.h"
#include "editor/panels/foot_cards.h"
#include "editor/panels/panels.h"
#include "editor/record/recording_wish.h"
#include "editor/record/sequence.h"
#include "editor/words/file_words.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

struct Size {
    const char* name;
    int width_px, height_px;
};
constexpr std::array<Size, 4> sizes{
    {{"720p", 1280, 720}, {"1080p", 1920, 1080}, {"4K", 3840, 2160}, {"Square", 1080, 1080}}};

void draw_size(const ui::Theme& theme, RecordPlan& plan)
{
    const float all = ui::label_row(theme, "Size", false, "Pixels across and down.").width;
    const float gap = theme.px(8), number = theme.px(72);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    int chosen = -1;
    std::vector<std::string> names;
    for (const Size& each : sizes) {
        if (each.width_px == plan.width_px && each.height_px == plan.height_px)
            chosen = static_cast<int>(names.size());
        names.emplace_back(each.name);
    }
    if (ui::segments(theme, "sizes", chosen, names, all - 2 * (number + gap)) ==
        ui::Edit::changed) {
        plan.width_px = sizes[static_cast<std::size_t>(chosen)].width_px;
        plan.height_px = sizes[static_cast<std::size_t>(chosen)].height_px;
    }
    const ui::NumberStyle px{.lo = 1, .hi = 16384};
    ImGui::SetCursorScreenPos({at.x + all - 2 * number - gap, at.y});
    ui::integer_field(theme, "width", plan.width_px, px, number);
    ImGui::SetCursorScreenPos({at.x + all - number, at.y});
    ui::integer_field(theme, "height", plan.height_px, px, number);
}

void browse(RecordDialog& dialog)
{
    const std::filesystem::path folder(with_long_home(dialog.plan.folder));
    dialog.browser.open({.title = "Folder of the pictures",
                         .action = "Choose",
                         .extensions = {},
                         .saving = true,
                         .folder = true,
                         .name = folder.filename().string()},
                        folder.parent_path());
}

// Whether the folders are to be looked through.
bool draw_plan(const ui::Theme& theme, RecordPlan& plan, const Session& session)
{
    const bool browsed =
        draw_path_row(theme, "Folder", plan.folder, "a folder", "Created if it does not exist.");
    const auto segments = [&](const char* label, int chosen, const std::vector<std::string>& names,
                              const char* help) {
        ui::segments(theme, label, chosen, names, ui::label_row(theme, label, false, help).width);
        return chosen;
    };
    plan.format = static_cast<RecordPlan::Format>(
        segments("Pictures", plan.format, {"PNG", "PNG, 16 bit", "EXR"},
                 "16 bit and EXR keep more levels of colour for work on the pictures."));
    draw_size(theme, plan);
    plan.level = static_cast<gpu::Level>(
        segments("Quality", static_cast<int>(plan.level), {"Draft", "Standard", "High"},
                 "High has finer shadows and edges, and takes four times as long."));
    draw_frames_row(theme, session.document().time, plan.first, plan.last, &plan.step);
    ui::label_row(theme, "Video", false, "Made by ffmpeg once all frames are rendered.");
    ui::check_box(
        theme, "video", plan.video,
        fmt::format("also an .mp4, {} frames per second",
                    number_text(session.document().time.frames_per_second, {.digits = 6})));
    return browsed;
}

// Describes the extent of the plan, and how much of it exists already.
std::string words_of(RecordDialog& dialog, const RecordingWish& wish)
{
    const FrameNames& names = wish.sequence.names;
    if (!dialog.there || dialog.there->first != dialog.plan)
        dialog.there = {dialog.plan,
                        static_cast<int>(wish.frames.size()) - wish.sequence.gone(wish.frames)};
    const int there = dialog.there->second;
    const auto name = [](const std::string& path) {
        return std::filesystem::path(path).filename().string();
    };
    std::string out = name(names.path(wish.frames.front()));
    if (wish.frames.size() > 1) out += " to " + name(names.path(wish.frames.back()));
    out +=
        wish.frames.size() == 1 ? ", one frame." : fmt::format(", {} frames.", wish.frames.size());
    if (!wish.camera) out += " Seen from the render camera.";
    if (there > 0)
        out += fmt::format(
            " {} {} there: frames that match the scene are kept, the others are rendered again.",
            there, there == 1 ? "file is" : "files are");
    return out;
}

} // namespace

void draw_record_dialog(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.memory.of<RecordDialog>();
    if (!dialog.open) return;
    if (dialog.browser.is_open()) {
        if (const auto folder = dialog.browser.draw(theme))
            dialog.plan.folder = with_short_home(*folder);
        return;
    }
    bool browsed = false;
    std::optional<RecordingWish> wish;
    const PlanAnswer answer = draw_plan_dialog(
        theme, {.title = "Record",
                .rows = 6,
                .fields = [&] { browsed = draw_plan(theme, dialog.plan, editor.session); },
                .come_to =
                    [&] {
                        wish = wish_of(dialog.plan, editor.session);
                        return words_of(dialog, *wish);
                    },
                .begin = [] { return std::string("Record"); }});
    if (browsed) browse(dialog);
    dialog.open = answer == PlanAnswer::none;
    if (answer != PlanAnswer::begun) return;
    dialog.card_hidden = false;
    editor.playback.pause();
    editor.recording.begin(std::move(*wish));
}

std::optional<ui::Rect> draw_recording(Editor& editor, const ui::Theme& theme,
                                       const FootCards& foot)
{
    if (!editor.recording.running() || editor.memory.of<RecordDialog>().card_hidden) return {};
    const ui::Palette& c = theme.color;
    const Recording::Status status = editor.recording.status();
    const glm::vec2 size(theme.px(440), theme.px(88));
    const float middle = std::round((foot.view().lo.x + foot.view().hi.x - size.x) / 2);
    const ui::Rect room = foot.above(middle, middle + size.x);
    const ui::Rect card =
        ui::rect_at({middle, std::round(room.hi.y - size.y - theme.px(16))}, size);
    ui::paint_card(theme, card);
    ui::lower_area("recording", card);
    const float pad = theme.px(12);
    const ui::Rect picture = ui::rect_at(card.lo + pad, {theme.px(114), size.y - 2 * pad});
    ui::paint_box(picture, c.field, theme.size.rounding);
    if (const gpu::Texture2D* last = editor.recording.last()) {
        const glm::vec2 own(last->size_px());
        const float share = std::min(picture.width() / own.x, picture.height() / own.y);
        const glm::vec2 lo = glm::round(picture.center() - own * share / 2.0f),
                        hi = lo + glm::round(own * share);
        ImGui::GetWindowDrawList()->AddImage(
            reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(last->name())), {lo.x, lo.y},
            {hi.x, hi.y});
    }
    const float stop = theme.px(64), x = picture.hi.x + theme.px(16);
    const ui::Rect text = {{x, card.lo.y + pad}, {card.hi.x - pad, card.hi.y - pad}};
    const auto line = [&](float top, const ImFont* font, ui::Color color, const std::string& words,
                          float width) {
        ui::paint_text(font, {{x, text.lo.y + top}, {x + width, text.lo.y + top + theme.px(20)}},
                       color, ui::elided(font, words, width));
    };
    const float beside = text.width() - stop - theme.px(12);
    line(theme.px(2), theme.font.strong, c.text, status.what, beside);
    line(theme.px(22), theme.font.small, c.text_2, status.left, beside);
    ui::Rect bar = {{x, card.hi.y - pad - theme.px(6)}, {text.hi.x, card.hi.y - pad}};
    ui::paint_box(bar, c.field, theme.px(3));
    bar.hi.x = bar.lo.x + bar.width() * static_cast<float>(std::clamp(status.fraction, 0.0, 1.0));
    ui::paint_box(bar, c.accent, theme.px(3));
    ImGui::SetCursorScreenPos({text.hi.x - stop, text.lo.y + theme.px(2)});
    if (ui::button(theme, "Stop", ui::ButtonKind::plain, {stop, theme.px(32)}))
        editor.recording.stop();
    return card;
}

void draw_record_button(Editor& editor, const ui::Theme& theme, glm::vec2 at)
{
    const glm::vec2 square(theme.size.icon_button);
    const Action& record = action(editor, record_action);
    const bool running = editor.recording.running();
    ImGui::SetCursorScreenPos({at.x, at.y});
    if (ui::icon_button(theme, "record", "", square,
                        tip_of(editor, record,
                               running ? "Shows or hides the progress of the recording."
                                       : "Renders the frames of the scene to files."),
                        {.enabled = is_enabled(editor, record)}))
        record.run(editor);
    const glm::vec2 middle = at + square / 2.0f;
    const ui::Color color = running                      ? theme.color.bad
                            : is_enabled(editor, record) ? theme.color.text_2
                                                         : theme.color.text_off;
    ui::paint_dot(middle, theme.px(running ? 3.5f : 4.5f), color);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float radius = theme.px(8);
    draw.AddCircle({middle.x, middle.y}, radius, running ? theme.color.text_off : color, 0,
                   theme.line(1.6f));
    if (!running) return;
    const auto done = static_cast<float>(std::clamp(editor.recording.status().fraction, 0.0, 1.0));
    constexpr float top = -1.5707963f, whole = 6.2831853f;
    draw.PathArcTo({middle.x, middle.y}, radius, top, top + std::max(0.02f, done) * whole, 32);
    draw.PathStroke(theme.color.bad, 0, theme.line(2));
}

} // namespace trivar
