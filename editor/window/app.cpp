// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/app.h"

#include "core/base/rejected.h"
#include "editor/actions/actions.h"
#include "editor/actions/all_actions.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/show_manual.h"
#include "editor/actions/use_keys.h"
#include "editor/editor.h"
#include "editor/panels/help/welcome.h"
#include "editor/session/scene_names.h"
#include "editor/window/draw_editor.h"
#include "editor/window/guarded.h"
#include "ui/window.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// Returns a path for state that is kept between two runs (XDG Base Directory Specification).
std::string kept(const std::string& name)
{
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state && std::filesystem::path(state).is_absolute())
        return state + std::string("/trivar/") + name;
    const char* home = std::getenv("HOME");
    return home && *home ? home + std::string("/.local/state/trivar/") + name : std::string();
}

// Tells a program that watches this one the most that the next frame can show.
void tell_steps(const SceneFile& scene)
{
    const History& history = scene.history();
    fmt::print("shows {} of {} steps, {} lines: {}\n", history.position(), history.steps().size(),
               scene.lines().size(), scene.path());
    std::fflush(stdout);
}

} // namespace

int run_editor(const EditorOptions& options)
{
    try {
        std::optional<gpu::ShaderFolder> shaders;
        if (!options.shaders.empty()) shaders.emplace(options.shaders);
        ui::Window window({.scale = options.scale});
        Editor editor(window.waker(), all_actions(), kept("unnamed"), OnFailure::leave_out);
        editor.memory.of<MistakeReports>().folder = kept("mistakes");
        PreferencesFile preferences(kept("preferences.json"));
        editor.preferences = preferences.read();
        editor.preferences_path = preferences.path();
        if (!preferences.trouble().empty())
            editor.session.notices.say(ui::NoticeKind::warning, preferences.trouble());
        editor.recovery.discarded_days = static_cast<int>(editor.preferences.discarded_days);
        editor.recovery.forget_discarded();
        if (shaders) editor.viewport.follow(std::move(*shaders));
        editor.memory.of<ManualPages>().folder = options.manual;
        editor.memory.of<SamplePictures>().folder = options.sample_pictures;
        editor.start_card.lacks_samples = options.samples.empty();
        add_tutorials(editor, options.tutorials);
        editor.files.samples = options.samples;
        editor.files.own_models_folder = options.models;
        add_samples(editor);
        use_keys(editor.actions, editor.preferences.keys);
        if (options.files.empty())
            editor.recovery.take_up_left_scene();
        else
            editor.recovery.tell_of_left_scene();
        editor.files.take_dropped(options.files);
        const auto& recent = editor.preferences.recent_scenes;
        const bool nothing = options.files.empty() && editor.session.scene().as_opened();
        if (nothing && editor.preferences.at_start == "last" && !recent.empty())
            editor.files.open_scene(std::string(recent.front()));
        std::string title;
        window.run(
            [&](ui::Frame& frame) {
                draw_editor(editor, frame);
                frame.look.light = frame.look.light || options.light;
                // Not at each step of a drag, which always ends in a frame.
                const bool dragging = ImGui::IsMouseDown(ImGuiMouseButton_Left);
                const std::string trouble = dragging ? "" : preferences.keep(editor.preferences);
                if (!trouble.empty())
                    editor.session.notices.say(ui::NoticeKind::warning,
                                               "Preferences were not saved", trouble);
                if (options.tell_steps) tell_steps(editor.session.scene());
                const std::string now =
                    fmt::format("{} - Trivar", title_of(editor.session.scene()));
                if (now == title) return;
                title = now;
                window.set_title(title);
            },
            [&] { editor.lose_context(); });
        return 0;
    } catch (const Rejected& why) {
        std::fprintf(stderr, "trivar: %s\n", why.what());
        return 1;
    }
}

} // namespace trivar
