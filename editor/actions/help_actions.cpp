// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/help_actions.h"

#include "editor/actions/hint_steps.h"
#include "editor/actions/menu.h"
#include "editor/actions/show_manual.h"
#include "editor/editor.h"
#include "editor/session/recent_scenes.h"
#include "editor/session/samples.h"

#include <algorithm>

namespace trivar {
namespace {

void tutorial_actions(std::vector<Action>& a)
{
    const Menu tutorials(a, "Tutorials");
    const auto at = [](std::string otherwise, auto holds) {
        return Condition{[holds](const Editor& e) {
                             return e.tutorial.runs(e.session) && holds(e.tutorial, e.session);
                         },
                         std::move(otherwise)};
    };
    tutorials(
        tutorial_next, {{ui::key_right}},
        [](Editor& e) { e.tutorial.next(e.session, e.preferences.reduced_motion); },
        at("no further tutorial step",
           [](const Tutorial& t, const Session& s) {
               return !t.note(s).empty() && t.step(s) < t.count();
           }),
        true);
    tutorials(
        tutorial_back, {{ui::key_left}}, [](Editor& e) { e.tutorial.back(e.session); },
        at("no earlier tutorial step", [](const Tutorial& t, const Session& s) {
            return !t.note(s).empty() && t.step(s) > 1;
        }));
    tutorials(
        tutorial_close, {{ui::key_escape}}, [](Editor& e) { e.tutorial.close(e.session); },
        at("no tutorial is open", [](const Tutorial&, const Session&) { return true; }));
    for (Action& each : a)
        if (each.menu == "Tutorials") each.keys_in = KeysIn::tutorial;
}

} // namespace

void add_help_actions(std::vector<Action>& a)
{
    const Menu help(a, "Help");
    help(palette_action, {{ui::key_f1 + 2}, {.key = 'P', .ctrl = true, .shift = true}},
         [](Editor& e) { e.palette.show(); });
    help("Manual", {{ui::key_f1}}, [](Editor& e) { show_manual(e, e.active_tool().facts().page); });
    help("Start card", {}, [](Editor& e) { e.start_card = {.asked = e.session.scenes()}; });
    help(show_hints_action, {}, show_hints_again,
         {[](const Editor& e) {
              return !e.preferences.hints || !e.preferences.closed_hints.empty();
          },
          "all hints are shown"});
    help("Keys and mouse", {}, [](Editor& e) { show_manual(e, keys_page); });
    tutorial_actions(a);
}

void add_tutorials(Editor& editor, const std::vector<std::string>& paths)
{
    auto at = std::ranges::find(editor.actions, tutorial_next, &Action::name);
    for (const std::string& path : paths) {
        const std::string title = scene_title(path);
        at = std::next(editor.actions.insert(at, {"Tutorials", title, {}, [path, title](Editor& e) {
                                                      e.files.open_copy(path, [&e, title] {
                                                          e.tutorial.begin(e.session, title);
                                                      });
                                                  }}));
    }
}

void add_samples(Editor& editor)
{
    for (const Sample& each : samples_among(editor.files.samples))
        editor.actions.push_back({"Samples", each.title, {}, [path = each.path](Editor& e) {
                                      e.files.open_scene(path);
                                  }});
}

bool has_tour(const Editor& editor)
{
    const auto first = std::ranges::find(editor.actions, "Tutorials", &Action::menu);
    return first != editor.actions.end() && first->name != tutorial_next;
}

void begin_tour(Editor& editor)
{
    const auto first = std::ranges::find(editor.actions, "Tutorials", &Action::menu);
    if (has_tour(editor)) first->run(editor);
}

} // namespace trivar
