// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"
#include "editor/editor.h"
#include "ui/paint.h"

// The panels of the window, each in a file of its own. A panel draws itself into its place and
// changes the editor by commands, proposals and actions.

namespace trivar {

struct OwnModel;

struct Layout {
    ui::Rect top, strip, options, view, timeline, outliner, tabs, inspector, status;
    bool dock = true; // whether the right column is there
    // The buttons of the tools stand in as few columns as have room for them, from the top down.
    int tool_rows = 1;
    float tool_gap = 0, tool_pad = 0; // between them, and above the first
    float tool_height = 0;
    ui::Rect tool_place(const ui::Theme& theme, std::size_t tool) const; // of its button
};
// Pixels at scale 1; the outliner takes at most 60 % of the dock.
inline constexpr float narrowest_dock = 280, widest_dock = 480, lowest_outliner = 120,
                       lowest_timeline = 160, least_view = 200;
Layout layout_of(const ui::Theme& theme, glm::vec2 size_px, const Preferences& preferences,
                 std::size_t tools, bool only_view = false);

// An undecorated window of a place; `scrolls` up and down. End with ImGui::End().
void begin_panel(const char* name, const ui::Rect& rect, ui::Color color, bool scrolls = false);

void draw_top_bar(Editor& editor, const ui::Theme& theme, const Layout& layout);
// Draws the menus at the left of the bar; returns where they end. `spread`: of the names, 1 if
// there is room.
float draw_menu_bar(Editor& editor, const ui::Theme& theme, const ui::Rect& bar, float spread);
// Width of the names of the menus, and of all between them where there is room; pixels.
struct MenuBarWidths {
    float names = 0, between = 0;
};
MenuBarWidths menu_bar_widths(const ui::Theme& theme);
inline constexpr float menus_left_px = 44; // where they begin, at scale 1
void draw_tool_strip(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_options_bar(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_viewport(Editor& editor, ui::Frame& frame, const Layout& layout);
void draw_timeline(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_outliner(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_tabs(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_inspector(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_history(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_log(Editor& editor, const ui::Theme& theme, const Layout& layout);
// The inputs of a hint with the keys that actions have at present; nothing where one has no key.
std::vector<std::string> inputs_now(const Editor& editor, const Hint& hint);
void draw_status_line(Editor& editor, const ui::Theme& theme, const Layout& layout);
void draw_manual(Editor& editor, const ui::Theme& theme);
void draw_command_palette(Editor& editor, const ui::Theme& theme);
void draw_filling(Editor& editor, const ui::Theme& theme); // of a command's values, in its place
void draw_preferences(Editor& editor, const ui::Theme& theme);
void draw_record_dialog(Editor& editor, const ui::Theme& theme);
void draw_export_dialog(Editor& editor, const ui::Theme& theme);
void draw_plain_mesh_dialog(Editor& editor, const ui::Theme& theme);
void draw_volume_dialog(Editor& editor, const ui::Theme& theme); // of what would come in
void draw_not_certified(Editor& editor, const ui::Theme& theme); // where it is read
void draw_record_button(Editor& editor, const ui::Theme& theme, glm::vec2 at);
// The lines between the panels; before the panels, so that they lie over them.
void drag_splitters(Editor& editor, ui::Frame& frame, const Layout& layout);

// Parts of the viewport, drawn inside its window.
class FootCards;
// Draws the legend of the colours of values in the picture. Cards at the foot return their
// rectangle if they are shown.
std::optional<ui::Rect> draw_legend(const Session& session, const ui::Theme& theme,
                                    const FootCards& foot);
bool has_room_for_axes(const ui::Theme& theme, const ui::Rect& view); // beside the labels
// `card`: at the top left; what would lie on it is not drawn.
void draw_navigation(Editor& editor, const ui::Theme& theme, const ui::Rect& view,
                     const std::optional<ui::Rect>& card);
void draw_welcome(Editor& editor, const ui::Theme& theme, const ui::Rect& view);
void draw_adjustment(Editor& editor, const ui::Theme& theme, const FootCards& foot);
std::optional<ui::Rect> draw_hint_card(Editor& editor, const ui::Theme& theme,
                                       const ui::Rect& view);
// Draws the progress of the running recording, and its last frame.
std::optional<ui::Rect> draw_recording(Editor& editor, const ui::Theme& theme,
                                       const FootCards& foot);
// Draws the models that can be painted with, while a tool works with such.
std::optional<ui::Rect> draw_tile_library(Editor& editor, const ui::Theme& theme,
                                          const FootCards& foot);
ui::Rect draw_tutorial(Editor& editor, ui::Frame& frame, const ui::Rect& view);

// A picture of a file, cut to the shape of its place; the place alone till it has been read.
void paint_picture(Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                   const std::string& path);

// Parts of the inspector. Each proposes what is being changed.
void draw_transform(Editor& editor, const ui::Theme& theme, Id id);
void draw_text(Editor& editor, const ui::Theme& theme, Id id); // of one that is letters
void draw_volume_data(Editor& editor, const ui::Theme& theme,
                      Id id); // levels and how they are read
void draw_material(Editor& editor, const ui::Theme& theme, Id id);
// Draws the shading of objects with faces, all as one; the last of them is the active one.
void draw_shading(Editor& editor, const ui::Theme& theme, const std::vector<Id>& ids);
void draw_placement(Editor& editor, const ui::Theme& theme, Id id);
void draw_travel(Editor& editor, const ui::Theme& theme, const std::vector<Id>& placed);
void draw_refinement(Editor& editor, const ui::Theme& theme, const std::vector<Id>& placed);
void draw_lattice(Editor& editor, const ui::Theme& theme, Id id); // of one that is a box
// The volume of a placed object or of a lattice, and what was done to it.
void draw_shaping(Editor& editor, const ui::Theme& theme, Id id);
void draw_clip(Editor& editor, const ui::Theme& theme, const std::vector<Id>& imported);
void draw_several(Editor& editor, const ui::Theme& theme); // where several objects are selected
void draw_picture_settings(Editor& editor, const ui::Theme& theme);
void draw_kept_view(Editor& editor, const ui::Theme& theme); // that of pictures, if there is one
// Numbers that no command sets and keys do.
void draw_other_numbers(Editor& editor, const ui::Theme& theme, Id id);

// The page of the preferences that shows every key and changes it.
void draw_key_map(Editor& editor, const ui::Theme& theme, const ui::Rect& page);

// An action as an item of the menu that is open.
void menu_item(Editor& editor, const Action& each);
// The models that come with the program, by their pictures, as a menu of the one that is open.
void draw_model_menu(Editor& editor, const ui::Theme& theme);
// One of them, with its name below; whether it was chosen.
bool draw_model(Editor& editor, const ui::Theme& theme, const ui::Rect& r, const OwnModel& model,
                bool chosen = false);
// The same for any model; `picture_path` may be empty.
bool draw_model_cell(Editor& editor, const ui::Theme& theme, const ui::Rect& r,
                     const std::string& name, const std::string& picture_path, bool chosen);
// While something is painted with tiles, models that are dropped become the tiles of the next
// stroke, and join the library, which the preferences keep; false: they are no models, or nothing
// is painted.
bool drop_tiles(Editor& editor, const std::vector<std::string>& paths);
// Draws the actions on the selection, as a popup of that name.
void draw_object_menu(Editor& editor, const ui::Theme& theme, const char* name);
void draw_add_menu(Editor& editor, const ui::Theme& theme); // at the mouse, when it is asked for
// The objects to which what used a deleted one can be bound; at the mouse, when it is asked for.
void draw_bind_menu(Editor& editor, const ui::Theme& theme);

// A row of the outliner; whether its menu is asked for.
bool draw_outline_row(Editor& editor, const ui::Theme& theme, const std::vector<OutlineRow>& rows,
                      std::size_t index, const ui::Rect& place);

} // namespace trivar
