// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/dialogs/preferences_pages.h"

#include "editor/actions/actions.h"
#include "editor/words/file_words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <thread>

namespace trivar {
namespace {

// Edits a speed, as a share of the usual.
void speed_row(const ui::Theme& theme, const char* label, double& value)
{
    const ui::Row row = ui::label_row(theme, label, value != 1);
    if (row.reset) value = 1;
    double percent = 100 * value;
    const ui::NumberStyle style{.lo = 10, .hi = 1000, .bar_hi = 300, .step = 5, .unit = "%"};
    if (ui::number_field(theme, label, percent, style, theme.px(160)) != ui::Edit::none)
        value = percent / 100;
}

// Where dialogs begin; says so where there is no such folder.
void folder_row(const ui::Theme& theme, const ui::Rect& r, const char* label, std::string& folder)
{
    const ui::Row row = ui::label_row(theme, label, !folder.empty());
    if (row.reset) folder.clear();
    ui::text_field(theme, label, folder, "Last used folder", row.width, ui::icon::folder);
    std::error_code ignored;
    if (!folder.empty() && !std::filesystem::is_directory(with_long_home(folder), ignored))
        foot_note(theme, r,
                  "There is no folder " + folder + ". Dialogs open in the last used folder.",
                  theme.color.warn);
}

} // namespace

void draw_general_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    choice_row(theme, "At start", p.at_start, usual.at_start,
               {{"card", "Start card"}, {"last", "Last scene"}, {"empty", "Empty scene"}});
    flag_row(theme, "Unnamed scenes", p.ask_to_keep, usual.ask_to_keep, "ask before closing");
    flag_row(theme, "Hints", p.hints, usual.hints, "show what to do next");
    flag_row(theme, "Playback", p.loop, usual.loop, "loop");
    foot_note(theme, r,
              "A saved scene is kept up to date as you work, so closing it asks nothing. Discarded "
              "scenes can be recovered " +
                  for_days(static_cast<int>(p.discarded_days)) +
                  " with File > Recover discarded scenes.");
}

void draw_interface_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    scale_row(editor, theme);
    std::string look = p.look.light ? "light" : "dark";
    choice_row(theme, "Theme", look, "dark", {{"dark", "Dark"}, {"light", "Light"}});
    p.look.light = look == "light";
    flag_row(theme, "Side panels", p.show_dock, usual.show_dock,
             "outliner and inspector at the right");
    flag_row(theme, "Timeline", p.timeline_open, usual.timeline_open, "open");
    foot_note(theme, r,
              "The size multiplies the display scale. Drag panel borders to resize them; "
              "double-click a border to reset it.");
}

void draw_viewport_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    std::string backdrop = p.backdrop_as_in_pictures ? "pictures" : "own";
    choice_row(theme, "Backdrop", backdrop, "own", {{"own", "Viewport"}, {"pictures", "Render"}});
    p.backdrop_as_in_pictures = backdrop == "pictures";
    if (!p.backdrop_as_in_pictures)
        flag_row(theme, "Grid", p.grid, usual.grid, "on the ground, with the axes");
    flag_row(theme, "Navigation", p.show_axes, usual.show_axes, "show the axes that turn the view");
    flag_row(theme, "Timing", p.show_timing, usual.show_timing, "show the frame time");
    choice_row(theme, "Triangles", p.view_tolerance, usual.view_tolerance,
               {{"off", "Original"}, {"2", "2 px"}, {"1", "1 px"}, {"0.5", "0.5 px"}});
    foot_note(theme, r,
              "Render uses the background of pictures. Triangles of placed objects can be "
              "split for the viewport only, until none is further than this many pixels from the "
              "true surface.");
}

void draw_mouse_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    MouseManners& m = editor.preferences.mouse;
    const MouseManners& was = usual_preferences().mouse;
    choice_row(theme, "Scrolling", m.device, was.device,
               {{"automatic", "Automatic"}, {"mouse", "Mouse"}, {"trackpad", "Trackpad"}});
    choice_row(theme, "Middle button", m.emulation, was.emulation,
               {{"alt", "Alt + left"},
                {"super", "Super + left"},
                {"space", "Space + left"},
                {"none", "Only itself"}});
    choice_row(theme, "Orbit about", m.orbit_about, was.orbit_about,
               {{"cursor", "Under the pointer"}, {"selection", "Selection"}, {"origin", "Origin"}});
    flag_row(theme, "Zoom", m.zoom_to_cursor, was.zoom_to_cursor, "towards the pointer");
    flag_row(theme, "Zoom direction", m.reversed_zoom, was.reversed_zoom,
             "wheel towards you zooms in");
    speed_row(theme, "Orbit speed", m.orbit);
    speed_row(theme, "Pan speed", m.pan);
    speed_row(theme, "Zoom speed", m.zoom);
    choice_row(theme, "Double click", editor.preferences.look.double_click_s,
               usual_preferences().look.double_click_s,
               {{0.2, "Quick"}, {0.3, "Normal"}, {0.5, "Slow"}, {0.8, "Slower"}});
    foot_note(
        theme, r,
        m.device == "mouse"
            ? "The wheel zooms; the middle button orbits, with Shift pans, with Ctrl zooms."
            : std::string("On a trackpad two fingers orbit, with Shift pan, with Ctrl zoom. ") +
                  (m.device == "automatic"
                       ? "Sideways or fractional scrolling is treated as a trackpad."
                       : "A mouse wheel then orbits, too."));
}

void draw_files_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    auto& dialog = editor.preferences_dialog;
    choice_row(theme, "Discarded scenes", p.discarded_days, usual.discarded_days,
               {{7, "7 days"}, {30, "30 days"}, {90, "90 days"}, {365, "A year"}});
    if (!dialog.discarded)
        dialog.discarded = SceneFile::set_aside_in(editor.session.unnamed_folder()).size();
    const std::size_t count = *dialog.discarded;
    ui::label_row(theme, "");
    if (count == 0) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({1, theme.size.row});
        ui::paint_text(theme.font.body, {{at.x, at.y}, {r.hi.x, at.y + theme.size.row}},
                       theme.color.text_3, "There are none");
    } else if (ui::button(theme,
                          fmt::format("Show the {}...", count == 1
                                                            ? "one there is"
                                                            : fmt::format("{} there are", count)),
                          ui::ButtonKind::plain, {theme.px(200), theme.size.row})) {
        dialog.open = false;
        editor.files.ask_discarded();
    }
    ui::gap(theme, 12);
    choice_row(theme, "Recent scenes", p.most_recent, usual.most_recent,
               {{0, "None"}, {4, "4"}, {8, "8"}, {16, "16"}});
    if (!p.recent_scenes.empty()) {
        ui::label_row(theme, " ");
        if (ui::button(theme,
                       fmt::format("Forget the {}",
                                   p.recent_scenes.size() == 1
                                       ? "one remembered"
                                       : fmt::format("{} remembered", p.recent_scenes.size())),
                       ui::ButtonKind::plain, {theme.px(200), theme.size.row})) {
            p.recent_scenes.clear();
            p.recent_views.clear();
        }
    }
    ui::gap(theme, 12);
    folder_row(theme, r, "Scenes", p.scenes_folder);
    folder_row(theme, r, "Models", p.models_folder);
    ui::gap(theme, 12);
    const auto where = [&](const char* label, const std::string& path) {
        ui::fact_row(theme, label, path.empty() ? "in memory only" : with_short_home(path),
                     theme.color.text_2);
    };
    where("Recovery folder", editor.session.unnamed_folder());
    where("Preferences", editor.preferences_path);
    foot_note(theme, r,
              "Every step is written to disk as you make it: to the scene file, or to the recovery "
              "folder until you first save. No timed autosave is needed.");
}

void draw_performance_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    choice_row(theme, "Quality", p.quality, usual.quality,
               {{"automatic", "Automatic"},
                {"draft", "Draft"},
                {"standard", "Standard"},
                {"high", "High"}});
    choice_row(theme, "While it moves", p.pace, usual.pace,
               {{"automatic", "Automatic"}, {"60", "60 / s"}, {"30", "30 / s"}, {"15", "15 / s"}});
    std::vector<NamedText> places{{"automatic", "Automatic"}};
    for (std::size_t i = 0; i < deform_words.size(); ++i)
        places.push_back({std::string(gpu::deform_names[i]), deform_words[i].name});
    choice_row(theme, "Deform", p.deform, usual.deform, places);
    const ui::Row row = ui::label_row(theme, "Threads", p.threads != 0);
    if (row.reset) p.threads = 0;
    const double all = std::max(1u, std::thread::hardware_concurrency());
    ui::number_field(
        theme, "threads", p.threads,
        {.lo = 0, .hi = 1024, .bar_hi = all, .step = 1, .zero = fmt::format("all {}", all)},
        theme.px(160));
    foot_note(theme, r,
              "Quality applies when nothing moves; during movement it drops to keep the frame "
              "rate. Placed objects are deformed by the "
              "processor, or by the graphics card: in one phase while they are drawn, in two "
              "phases once before that. Automatic: two phases if there is a card. Use fewer "
              "threads to leave some to other programs; results are the same.");
}

void draw_accessibility_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    Preferences& p = editor.preferences;
    const Preferences& usual = usual_preferences();
    scale_row(editor, theme);
    flag_row(theme, "Contrast", p.look.high_contrast, usual.look.high_contrast, "high");
    flag_row(theme, "Overlays", p.look.other_hues, usual.look.other_hues,
             "colours for colour-blind eyes");
    choice_row(theme, "Lines", p.look.lines, usual.look.lines,
               {{1, "Normal"}, {1.5, "Wide"}, {2, "Wider"}, {3, "Widest"}});
    flag_row(theme, "Motion", p.reduced_motion, usual.reduced_motion,
             "reduced: no animated transitions");
    flag_row(theme, "Dragging", p.look.click_holds, usual.look.click_holds,
             "click to start and end drags");
    choice_row(theme, "Tooltips after", p.look.tooltip_s, usual.look.tooltip_s,
               {{0.15, "0.15 s"}, {0.5, "0.5 s"}, {1, "1 s"}, {2, "2 s"}});
    const std::string key = key_text(action(editor, palette_action));
    foot_note(theme, r,
              "Lines are the handles, strokes, lattices and outlines in the viewport. Every colour "
              "also has a shape. " +
                  (key.empty() ? "Help > Find a command" : key) +
                  " finds every command by its letters.");
}

} // namespace trivar
