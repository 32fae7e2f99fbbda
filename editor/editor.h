// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"
#include "editor/commands/adjustment.h"
#include "editor/commands/command_field.h"
#include "editor/commands/command_palette.h"
#include "editor/files/export_plan.h"
#include "editor/files/files.h"
#include "editor/files/picture_to_file.h"
#include "editor/help/tutorial.h"
#include "editor/memory.h"
#include "editor/picture/stored_pictures.h"
#include "editor/preferences/preferences.h"
#include "editor/preferences/preferences_dialog.h"
#include "editor/record/record_plan.h"
#include "editor/session/outline.h"
#include "editor/session/recovery.h"
#include "editor/timeline/key_target.h"
#include "editor/timeline/playback.h"
#include "editor/timeline/state.h"
#include "editor/tools/all_tools.h"
#include "editor/viewport/viewport.h"
#include "ui/timing_overlay.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The whole editor between two frames. Panels and actions read and change it; nothing else holds
// state.
struct Editor {
    Editor(std::function<void()> wake, std::vector<Action> table_of_actions,
           std::string unnamed_folder = {}, OnFailure on_failure = OnFailure::pass_on);
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    const OnFailure on_failure; // of a step of an object, a panel or a tool
    Session session;
    Recovery recovery{session};
    Files files{session, recovery};
    Viewport viewport;
    std::vector<std::unique_ptr<Tool>> tools = all_tools();
    std::size_t tool = 0; // index of the active one
    std::vector<Action> actions;

    // Layout, and what several panels or actions know.
    Preferences preferences;
    bool only_view = false, full_screen = false;
    Shading shading;
    PictureToFile picture_to_file;
    Recording recording;
    FramesExport frames_export;
    ui::TimingView timing;
    enum class Tab { inspector, history, log } tab = Tab::inspector;
    OutlinerState outliner;
    Playback playback;
    using Timeline = TimelineState;
    Timeline timeline;
    enum class Panel { view, outliner, dock } panel = Panel::view; // the keyboard's
    bool show_focus = false;                                       // it came there by a key
    Adjustment adjustment;
    bool add_menu_asked = false;  // it opens at the mouse in the next frame
    bool right_cancelled = false; // the right button, which is held, ended a gesture
    bool inspecting = false;      // a proposal of the inspector is pending
    KeyTarget keys_under_mouse;   // the numbers of the field that it is over
    struct StartCard {   // numbers of the session's scenes, for each of which it begins anew
        long asked = -1; // over whatever is there, by Help
        long left = -1;  // it was left by New scene
        bool lacks_samples = false;         // they were not where they come with the program
        std::vector<ui::Rect> entries = {}; // as they were drawn last, in their order
        int at = -1;                        // the one that the keyboard is at; -1: none yet
    } start_card;
    StoredPictures stored_pictures;
    Tutorial tutorial;
    PreferencesDialog preferences_dialog;
    std::string preferences_path; // of the file they are kept in; empty: in memory
    CommandPalette palette;
    CommandField command_field;
    Memory memory; // what one panel or action alone knows

    // Drops the contents of a lost context after a reset of the graphics card, and says so.
    void lose_context();
    Tool& active_tool() { return *tools[tool]; }
    const Tool& active_tool() const { return *tools[tool]; }
    // The active tool as one that works on parts, or with models; null: it is none.
    PartsTool* tool_parts() const { return tools[tool]->parts(); }
    ModelTool* tool_models() const { return tools[tool]->models(); }
    void choose_tool(std::size_t index);
    void choose_tool(std::string_view name); // nothing happens where there is none
};

} // namespace trivar
