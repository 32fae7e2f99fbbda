// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/palette_entries.h"

#include "core/commands/every_command.h"
#include "core/commands/objects/view.h"
#include "editor/actions/actions.h"
#include "editor/actions/menus_beside.h"
#include "editor/actions/model_actions.h"
#include "editor/commands/as_it_is.h"
#include "editor/commands/typed_command.h"
#include "editor/editor.h"
#include "editor/tools/place/place.h"
#include "ui/icons.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace trivar {
namespace {

const char* icon_of(const Editor& editor, const Action& each)
{
    if (each.menu == "Tools")
        for (const auto& tool : editor.tools)
            if (tool->name() == each.name) return tool->facts().icon;
    if (each.menu == "Add" || each.menu == models_menu) return ui::icon::add;
    if (each.menu == "File") return ui::icon::file;
    if (menu_path(each).starts_with("View")) return ui::icon::eye;
    if (each.menu == "Help") return ui::icon::help;
    return ui::icon::pencil;
}

// "set_material": "Set material".
std::string words_of(std::string_view verb)
{
    if (verb == SetRender::verb) return "Picture settings"; // as the inspector calls them
    std::string words(verb);
    std::ranges::replace(words, '_', ' ');
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

// Returns the command on the selection, filled in with the present values.
Command about_selection(const Command& command, const Editor& editor)
{
    const Session& session = editor.session;
    const Document& document = session.document();
    Command ready = as_it_is(command, session.selected, document).value_or(command);
    ready = about(ready, topmost(document, session.selected.ids()));
    if (auto* c = ready.edit<Place>()) { // in the present view
        c->sketch.camera = session.view.camera;
        c->object = model_to_place(session, 0);
        c->onto = bases_for_stroke(session, c->object);
    }
    if (auto* c = ready.edit<KeepView>()) *c = {"View", session.view.camera};
    if (auto* c = ready.edit<ForgetView>(); c && !document.kept_views.empty())
        c->name = document.kept_views.begin()->first;
    return ready;
}

constexpr const char* empty_scene = "the scene is empty";

// Returns why the command does not fit the selection; empty: it does. When values are filled in,
// another object can be named.
std::string why_not(const Command& command, const Editor& editor)
{
    const Document& document = editor.session.document();
    if (command.is<ForgetView>() && document.kept_views.empty()) return "there is no bookmark";
    if (!is_about_objects(command)) return {};
    if (document.objects.empty()) return empty_scene;
    return nature_of(command).asked == Invocation::at_once && editor.session.selected == 0
               ? "select an object first"
               : "";
}

// Writes a command that cannot be filled in field by field into the field of the log, to be
// changed.
void write_into_log(const Command& ready, Editor& editor)
{
    editor.preferences.show_dock = true;
    editor.only_view = false;
    editor.tab = Editor::Tab::log;
    CommandField& field = editor.command_field;
    field.text = typed_text(ready, editor.session.document());
    field.trouble.clear();
    field.focus = true;
}

// The command that an action of that name runs, where it is one with values of its own.
std::optional<Command> command_called(const std::string& entry,
                                      const std::vector<Command>& commands)
{
    const auto lower = [](std::string text) {
        std::ranges::transform(text, text.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    const std::string name = lower(entry);
    for (const Command& each : commands) {
        const std::string words = lower(words_of(verb(each)));
        if (name == words || (words.starts_with("add ") && name.starts_with(words + " ")))
            return each;
    }
    return std::nullopt;
}

} // namespace

std::vector<PaletteEntry> palette_commands(const Editor& editor)
{
    std::vector<PaletteEntry> entries;
    const std::vector<Command> commands = every_command();
    for (const Action& each : editor.actions) {
        if (each.name == palette_action) continue; // it is open
        const bool add = each.menu == "Add" || each.menu == models_menu;
        std::vector<std::string> caps;
        if (!each.keys.empty()) caps = ui::caps_of(each.keys.front());
        entries.push_back({add ? "Add " + each.name : each.name, menu_path(each),
                           icon_of(editor, each), caps,
                           is_enabled(editor, each) ? "" : each.enabled.otherwise,
                           [name = each.name](Editor& e) { action(e, name).run(e); }, each.name});
        PaletteEntry& entry = entries.back();
        if (menu_path(each).starts_with("Tools") && each.name != "Place")
            continue; // their values come from a hand
        const auto command = command_called(entry.name, commands);
        if (command && why_not(*command, editor) != empty_scene)
            entry.fill = about_selection(*command, editor);
    }
    for (const Command& each : commands) {
        if (nature_of(each).asked == Invocation::by_actions) continue;
        const Command ready = about_selection(each, editor);
        const bool written = each.is<Relink>();
        const std::string missing = why_not(each, editor);
        const auto summary = visit([](const auto& c) { return c.summary; }, each);
        entries.push_back({words_of(verb(each)),
                           std::string(summary),
                           ui::icon::log,
                           {},
                           missing,
                           [ready, written](Editor& e) {
                               written ? write_into_log(ready, e) : void(e.session.run(ready));
                           },
                           {},
                           written || missing == empty_scene ? std::nullopt : std::optional(ready),
                           !written && nature_of(each).asked == Invocation::with_values});
    }
    return entries;
}

std::vector<PaletteEntry> palette_objects(const Editor& editor)
{
    std::vector<PaletteEntry> entries;
    for (const auto& [id, each] : editor.session.document().objects)
        entries.push_back(
            {each->name, type_of(*each), icon_of(*each), {}, {}, [id = id](Editor& e) {
                 e.session.selected = id;
             }});
    return entries;
}

std::vector<PaletteEntry> palette_preferences(const Editor& editor)
{
    const Preferences& p = editor.preferences;
    std::vector<PaletteEntry> entries;
    const auto add = [&](const std::string& name, bool on, auto change) {
        entries.push_back(
            {name, on ? "on" : "off", ui::icon::settings, {}, {}, [change](Editor& e) {
                 change(e.preferences);
             }});
    };
    add("Light theme", p.look.light, [](Preferences& q) { q.look.light = !q.look.light; });
    add("High contrast", p.look.high_contrast,
        [](Preferences& q) { q.look.high_contrast = !q.look.high_contrast; });
    add("Overlays for colour-blind eyes", p.look.other_hues,
        [](Preferences& q) { q.look.other_hues = !q.look.other_hues; });
    add("Side panels", p.show_dock, [](Preferences& q) { q.show_dock = !q.show_dock; });
    add("Hints", p.hints, [](Preferences& q) { q.hints = !q.hints; });
    add("Reduced motion", p.reduced_motion,
        [](Preferences& q) { q.reduced_motion = !q.reduced_motion; });
    add("Click to start and end drags", p.look.click_holds,
        [](Preferences& q) { q.look.click_holds = !q.look.click_holds; });
    add("Backdrop as in pictures", p.backdrop_as_in_pictures,
        [](Preferences& q) { q.backdrop_as_in_pictures = !q.backdrop_as_in_pictures; });
    add("Grid", p.grid, [](Preferences& q) { q.grid = !q.grid; });
    add("Navigation axes", p.show_axes, [](Preferences& q) { q.show_axes = !q.show_axes; });
    add("Show frame time", p.show_timing, [](Preferences& q) { q.show_timing = !q.show_timing; });
    add("Ask before closing unnamed scenes", p.ask_to_keep,
        [](Preferences& q) { q.ask_to_keep = !q.ask_to_keep; });
    add("Zoom towards the pointer", p.mouse.zoom_to_cursor,
        [](Preferences& q) { q.mouse.zoom_to_cursor = !q.mouse.zoom_to_cursor; });
    add("Reversed zoom", p.mouse.reversed_zoom,
        [](Preferences& q) { q.mouse.reversed_zoom = !q.mouse.reversed_zoom; });
    for (int page = 0; page < PreferencesDialog::page_count; ++page)
        entries.push_back(
            {preferences_page_name(page), "page", ui::icon::settings, {}, {}, [page](Editor& e) {
                 e.preferences_dialog = {};
                 e.preferences_dialog.open = true;
                 e.preferences_dialog.page = page;
             }});
    for (const double scale : interface_scales)
        add("Interface size " + std::to_string(static_cast<int>(100 * scale + 0.5)) + " %",
            p.scale == scale, [scale](Preferences& q) { q.scale = scale; });
    return entries;
}

} // namespace trivar
