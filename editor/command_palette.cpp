// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_palette.h"

#include "editor/actions.h"
#include "editor/editor.h"
#include "editor/letters_in_order.h"
#include "editor/panels/panels.h"
#include "editor/typed_command.h"
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
            if (tool->name() == each.name) return tool->icon();
    if (each.menu == "Add") return ui::icon::add;
    if (each.menu == "File") return ui::icon::file;
    if (each.menu == "View") return ui::icon::eye;
    if (each.menu == "Help") return ui::icon::help;
    return ui::icon::pencil;
}

// "set_material": "Set material".
std::string words_of(std::string_view verb)
{
    std::string words(verb);
    std::ranges::replace(words, '_', ' ');
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

// Commands that an action or a tool runs already, with all that they need.
bool has_an_action(std::string_view verb)
{
    constexpr std::array<std::string_view, 9> known{"import",    "rename",  "delete",
                                                    "duplicate", "group",   "ungroup",
                                                    "place",     "unplace", "arrange"};
    return verb.starts_with("add_") || std::ranges::find(known, verb) != known.end();
}

// The command about the selection; what it leaves as it is stands in it already.
Command about_selection(Command command, const Editor& editor)
{
    const Session& session = editor.session;
    std::visit(
        [&](auto& c) {
            if constexpr (requires { c.objects; })
                c.objects = topmost(session.document(), session.selected.ids());
            if constexpr (requires { c.object; }) c.object = session.selected;
        },
        command);
    const auto found = session.document().objects.find(session.selected);
    const Object* object = found == session.document().objects.end() ? nullptr : &*found->second;
    if (auto* c = std::get_if<SetTransform>(&command); c && object)
        c->transform = object->transform;
    if (auto* c = std::get_if<EditImport>(&command); c && object)
        if (const auto* file = std::get_if<ImportedFile>(&object->source)) c->file = *file;
    if (auto* c = std::get_if<SetMaterial>(&command); c && object && object->surfacing)
        c->surfacing = *object->surfacing;
    if (auto* c = std::get_if<EditPlacement>(&command); c && object && object->placement)
        c->parameters = object->placement->parameters;
    if (auto* c = std::get_if<SetRender>(&command)) c->settings = *session.document().render;
    if (auto* c = std::get_if<SaveCamera>(&command)) *c = {"View", session.camera};
    if (auto* c = std::get_if<DeleteCamera>(&command); c && !session.document().bookmarks.empty())
        c->name = session.document().bookmarks.begin()->first;
    return command;
}

std::string why_not(const Command& command, const Editor& editor)
{
    const Document& document = editor.session.document();
    const bool needs_object = std::visit(
        [](const auto& c) {
            return requires
            {
                c.object;
            }
            || requires
            {
                c.objects;
            };
        },
        command);
    const auto found = document.objects.find(editor.session.selected);
    if (needs_object && found == document.objects.end()) return "select an object first";
    if (std::holds_alternative<EditPlacement>(command) && !found->second->placement)
        return "select a placed object first";
    if (std::holds_alternative<EditImport>(command) &&
        !std::holds_alternative<ImportedFile>(found->second->source))
        return "select an imported model first";
    if (std::holds_alternative<DeleteCamera>(command) && document.bookmarks.empty())
        return "no view is kept";
    return {};
}

// Those that need nothing but the objects run; for the others the line to be changed is written
// into the field of the log.
void run_or_write(const Command& command, Editor& editor)
{
    const Command ready = about_selection(command, editor);
    const bool needs_values = !std::holds_alternative<Hide>(command) &&
                              !std::holds_alternative<Show>(command) &&
                              !std::holds_alternative<ClearMaterial>(command);
    if (!needs_values) {
        editor.session.run(ready);
        return;
    }
    editor.preferences.show_dock = true;
    editor.only_view = false;
    editor.tab = Editor::Tab::log;
    Editor::CommandField& field = editor.command_field;
    field.text = typed_text(ready, editor.session.document());
    field.trouble.clear();
    field.focus = true;
}

} // namespace

std::vector<PaletteEntry> palette_commands(const Editor& editor)
{
    std::vector<PaletteEntry> entries;
    for (const Action& each : editor.actions) {
        if (each.name == palette_action) continue; // it is open
        const bool add = each.menu == "Add";
        std::vector<std::string> caps;
        if (!each.keys.empty()) caps = ui::caps_of(each.keys.front());
        entries.push_back({add ? "Add " + each.name : each.name, each.menu, icon_of(editor, each),
                           caps, is_enabled(editor, each) ? "" : each.enabled.otherwise,
                           [name = each.name](Editor& e) { action(e, name).run(e); }, each.name});
    }
    for (const Command& each : every_command()) {
        if (has_an_action(verb(each))) continue;
        const auto summary = std::visit([](const auto& c) { return c.summary; }, each);
        entries.push_back({words_of(verb(each)),
                           std::string(summary),
                           ui::icon::log,
                           {},
                           why_not(each, editor),
                           [each](Editor& e) { run_or_write(each, e); }});
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
    add("Backdrop as in pictures", p.backdrop_as_in_pictures,
        [](Preferences& q) { q.backdrop_as_in_pictures = !q.backdrop_as_in_pictures; });
    for (const double scale : interface_scales)
        add("Size of the interface " + std::to_string(static_cast<int>(100 * scale + 0.5)) + " %",
            p.scale == scale, [scale](Preferences& q) { q.scale = scale; });
    return entries;
}

std::vector<Ranked> ranked(std::string_view letters, const std::vector<std::string>& names,
                           const std::vector<std::string>& recent)
{
    struct Scored {
        Ranked ranked;
        int score = 0;
        std::size_t used = 0; // place among the recent ones
    };
    const bool all = letters.find_first_not_of(' ') == letters.npos;
    std::vector<Scored> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::optional<LetterMatch> match = letters_in_order(letters, names[i]);
        if (!match) continue;
        const auto place = std::ranges::find(recent, names[i]);
        found.push_back({{i, std::move(match->at), all && place != recent.end()},
                         match->score,
                         static_cast<std::size_t>(place - recent.begin())});
    }
    std::ranges::stable_sort(found, [](const Scored& a, const Scored& b) {
        return a.score != b.score ? a.score > b.score : a.used < b.used;
    });
    std::vector<Ranked> result;
    result.reserve(found.size());
    for (Scored& each : found) result.push_back(std::move(each.ranked));
    return result;
}

} // namespace trivar
