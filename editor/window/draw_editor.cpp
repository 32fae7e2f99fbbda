// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/draw_editor.h"

#include "editor/actions/hint_steps.h"
#include "editor/actions/mask_actions.h"
#include "editor/actions/run_keys.h"
#include "editor/editor.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"
#include "editor/session/recent_scenes.h"
#include "editor/session/recent_views.h"
#include "editor/window/guarded.h"

#include <filesystem>
#include <imgui.h>

namespace trivar {
namespace {

// Behind all panels, so that the gaps between them are lines.
void paint_ground(const ui::Theme& theme, glm::vec2 size_px)
{
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {size_px.x, size_px.y}, theme.color.gap);
}

// Adds the scene to the list of recent ones; a scene without a name is in no list.
void remember_scene(Editor& editor)
{
    const std::string& named = editor.session.scene().path();
    if (named.empty()) return;
    const std::string path = std::filesystem::absolute(named).lexically_normal().string();
    std::vector<std::string>& recent = editor.preferences.recent_scenes;
    const auto most = static_cast<std::size_t>(editor.preferences.most_recent);
    if (most == 0 || (!recent.empty() && recent.front() == path)) return;
    remember(recent, path, most);
    forget_moved(recent, path);
}

// Copies the preferences that others hold.
void apply_preferences(Editor& editor)
{
    Preferences& p = editor.preferences;
    const auto most = static_cast<std::size_t>(p.most_recent);
    if (p.recent_scenes.size() > most) p.recent_scenes.resize(most);
    editor.recovery.discarded_days = static_cast<int>(p.discarded_days);
    editor.files.ask_to_keep = p.ask_to_keep;
    editor.files.scenes_folder = p.scenes_folder;
    editor.files.models_folder = p.models_folder;
    if (!editor.files.use_dropped_image)
        editor.files.use_dropped_image = [&editor](const std::string& path) {
            use_image(editor, path);
        };
    editor.viewport.set_manners(p.mouse);
    const int threads = static_cast<int>(p.threads);
    auto& in_force = editor.memory.of<PreferencesInForce>();
    if (threads == in_force.threads) return;
    in_force = {threads, threads > 0 ? std::make_unique<ThreadLimit>(threads) : nullptr};
}

struct KnownScene { // the session's scene that the tools know
    long number = 0;
};

struct ViewMet { // how the scene of that number and path is looked at
    long scene = -1;
    std::string path;
    Camera camera;
    double since_s = 0;
    bool remembered = false;
};

// Every scene opens as it was looked at last, but where it has a view of its own.
void remember_view(Editor& editor, ui::Frame& frame)
{
    constexpr double quiet_s = 1; // not at each frame of a turn
    ViewMet& met = editor.memory.of<ViewMet>();
    Session& session = editor.session;
    std::vector<std::string>& views = editor.preferences.recent_views;
    const auto keep = [&] {
        if (met.remembered || met.path.empty()) return;
        met.remembered = true;
        remember_view_of(views, met.path, met.camera,
                         static_cast<std::size_t>(editor.preferences.most_recent));
    };
    const std::string& named = session.scene().path();
    const std::string path =
        named.empty() ? "" : std::filesystem::absolute(named).lexically_normal().string();
    if (met.scene != session.scenes()) {
        if (met.scene >= 0) keep();
        met = {session.scenes(), path, session.view.camera, frame.time_s, true};
        const auto view = view_of(views, path);
        if (!view || session.document().kept_views.contains("picture")) return;
        session.view.go_to = view;
        session.view.frame_all_when_evaluated = false;
        return;
    }
    const bool same = met.camera == session.view.camera && met.path == path;
    if (!same) met = {met.scene, path, session.view.camera, frame.time_s, false};
    if (met.remembered || path.empty()) return;
    if (frame.close_asked || frame.time_s - met.since_s >= quiet_s)
        keep();
    else
        frame.again_in(quiet_s);
}

// Ends work that belongs to a scene that is gone.
void meet_scene(Editor& editor)
{
    long& met = editor.memory.of<KnownScene>().number;
    if (met == editor.session.scenes()) return;
    met = editor.session.scenes();
    editor.active_tool().cancel(editor.session);
    editor.outliner = {};
    const bool open = editor.adjustment.open;
    editor.adjustment = {};
    editor.adjustment.open = open;
    editor.inspecting = false;
    editor.playback.pause();
    editor.timeline = {};
}

// The keyboard is where the mouse was pressed last.
void follow_click(Editor& editor, const Layout& layout)
{
    using Panel = Editor::Panel;
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    const ImVec2 p = ImGui::GetIO().MousePos;
    const glm::vec2 at{p.x, p.y};
    editor.show_focus = false;
    editor.panel = !layout.dock                    ? Panel::view
                   : layout.outliner.contains(at)  ? Panel::outliner
                   : layout.inspector.contains(at) ? Panel::dock
                                                   : Panel::view;
}

// Where the keyboard is, once it went there by a key.
void paint_focus(const Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    using Panel = Editor::Panel;
    if (!editor.show_focus || editor.only_view) return;
    const ui::Rect dock = {layout.tabs.lo, layout.inspector.hi};
    const ui::Rect& r = editor.panel == Panel::view       ? layout.view
                        : editor.panel == Panel::outliner ? layout.outliner
                                                          : dock;
    if (editor.panel != Panel::view && !layout.dock) return;
    const float half = 0.75f * theme.scale;
    ImGui::GetForegroundDrawList()->AddRect({r.lo.x + half, r.lo.y + half},
                                            {r.hi.x - half, r.hi.y - half}, theme.color.focus, 0, 0,
                                            2 * half);
}

// Takes in what came since the last frame.
void take_in(Editor& editor, ui::Frame& frame)
{
    apply_preferences(editor);
    editor.session.poll();
    editor.stored_pictures.poll();
    editor.frames_export.poll();
    editor.playback.advance(editor.session, frame, editor.preferences.loop);
    editor.session.try_to_write(frame.time_s);
    editor.session.follow_file(frame.time_s);
    if (editor.session.scene().look_only()) frame.again_in(1);
    if (!editor.session.scene().trouble().empty()) frame.again_in(5);
    remember_scene(editor);
    remember_view(editor, frame);
    editor.session.warnings_beside =
        editor.preferences.show_dock && !editor.only_view && editor.tab == Editor::Tab::inspector;
}

void hear(Editor& editor, const ui::Frame& frame)
{
    for (const ui::Event& event : frame.events) {
        if (event.kind == ui::Event::Kind::drop && !drop_tiles(editor, event.paths))
            editor.files.drop(event.paths);
        // Somewhere else has the keyboard now: a gesture would go on without its end.
        if (event.kind != ui::Event::Kind::focus || event.down) continue;
        editor.active_tool().cancel(editor.session);
        editor.memory.of<HeldSpace>() = {};
    }
    if (frame.close_asked) editor.files.ask_close();
    // Its Enter is not the outliner's.
    if (editor.active_tool().busy()) editor.panel = Editor::Panel::view;
    run_keys(editor);
    meet_scene(editor);
}

} // namespace

void draw_editor(Editor& editor, ui::Frame& frame)
{
    const ui::Theme& theme = frame.theme;
    const auto guarded = [&](const std::function<void()>& part) {
        const bool whole = do_guarded(editor, part);
        constexpr double soon_s = 0.1; // without what may have failed
        if (!whole) frame.again_in(soon_s);
        return whole;
    };
    editor.session.be_at_work(true);
    guarded([&] { take_in(editor, frame); });
    guarded([&] { tell_failed_steps(editor); });
    const long change = editor.session.change();
    guarded([&] { hear(editor, frame); });

    const auto arranged = [&] {
        return layout_of(theme, frame.size_px, editor.preferences, editor.tools.size(),
                         editor.only_view);
    };
    drag_splitters(editor, frame, arranged());
    const Layout layout = arranged();
    follow_click(editor, layout);
    paint_ground(theme, frame.size_px);
    editor.timeline.hovered = false;
    editor.keys_under_mouse = {};
    using Panel = void (*)(Editor&, const ui::Theme&, const Layout&);
    const auto draw = [&](Panel panel) { guarded([&] { panel(editor, theme, layout); }); };
    if (!editor.only_view)
        for (const Panel each : {draw_top_bar, draw_tool_strip, draw_options_bar, draw_timeline})
            draw(each);
    const bool history = layout.dock && editor.tab == Editor::Tab::history;
    if (!history) guarded([&] { editor.session.preview(nullptr); });
    if (layout.dock) {
        draw(draw_outliner);
        draw(draw_tabs);
        draw(editor.tab == Editor::Tab::inspector ? draw_inspector
             : editor.tab == Editor::Tab::history ? draw_history
                                                  : draw_log);
    }
    guarded([&] {
        finish_edit(editor);
        follow_steps(editor.adjustment, editor.session);
        follow_hints(editor);
    });
    // Last of the panels: it shows what they changed.
    if (!guarded([&] { draw_viewport(editor, frame, layout); }))
        editor.session.notices.draw(frame, layout.view);
    draw(draw_status_line);
    paint_focus(editor, theme, layout);
    guarded([&] { editor.files.draw(theme); });
    using Dialog = void (*)(Editor&, const ui::Theme&);
    for (const Dialog dialog :
         {draw_manual, draw_preferences, draw_record_dialog, draw_export_dialog,
          draw_plain_mesh_dialog, draw_volume_dialog, draw_not_certified, draw_command_palette})
        guarded([&] { dialog(editor, theme); });
    remember_popups(editor);
    // Panels drawn before the change still show what was there.
    if (editor.session.change() != change || editor.outliner.scrolling) frame.again_in(0);
    frame.close = editor.files.close_agreed();
    frame.interface_scale = editor.preferences.scale;
    frame.look = editor.preferences.look;
    frame.full_screen = editor.full_screen;
    editor.session.be_at_work(false);
}

} // namespace trivar
