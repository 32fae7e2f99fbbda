// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/time_actions.h"

#include "core/commands/objects/play.h"
#include "core/commands/objects/view.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/session/topics.h"
#include "editor/timeline/travel_time.h"

namespace trivar {
namespace {

// An action that shows another frame, which it finds from the present one.
Action frame_action(const char* name, const ui::Chord& key, int (*found)(const Session&))
{
    Action action{"Animate", name, {key}, [found](Editor& e) {
                      e.playback.pause();
                      e.session.show_frame(found(e.session));
                  }};
    action.keys_in = KeysIn::picture;
    return action;
}

// Imported models come with clips of which none is chosen: where nothing else would move, each
// begins its first one, in one step.
void begin_clips(Session& session)
{
    const Document& document = session.document();
    if (moves_in_time(document) || session.proposing() || session.scene().look_only()) return;
    PlayClip command;
    std::string names;
    for (const auto& [id, effects] : session.evaluated().objects) {
        if (!document.objects.contains(id) || effects->clips.empty() || !visible(document, id))
            continue;
        Playing playing = object(document, id).playing;
        playing.clip = effects->clips.front();
        command.objects.push_back(id);
        command.playings.push_back(std::move(playing));
        names +=
            (names.empty() ? "" : ", ") + name_of(document, id) + ": " + effects->clips.front();
    }
    if (!command.objects.empty() && session.run(command))
        session.notices.say(ui::NoticeKind::good, "Plays the first clip",
                            names + ". The inspector has the others.", of_a_step);
}

} // namespace

void add_time_actions(std::vector<Action>& a)
{
    const Menu animate(a, "Animate");
    animate(play_action, {{ui::key_space}}, [](Editor& e) {
        if (e.playback.playing()) return e.playback.pause();
        begin_clips(e.session);
        e.playback.play(e.session);
    });
    animate(loop_action, {}, [](Editor& e) { e.preferences.loop = !e.preferences.loop; }).on =
        [](const Editor& e) { return e.preferences.loop; };
    a.push_back(frame_action(next_frame_action, {ui::key_right},
                             [](const Session& s) { return s.frame() + 1; }));
    a.back().group_begins = true;
    a.back().repeats = true;
    a.push_back(frame_action(previous_frame_action, {ui::key_left},
                             [](const Session& s) { return s.frame() - 1; }));
    a.back().repeats = true;
    a.push_back(frame_action(first_frame_action, {.key = ui::key_left, .shift = true},
                             [](const Session& s) { return s.document().time.first_frame; }));
    a.push_back(frame_action(last_frame_action, {.key = ui::key_right, .shift = true},
                             [](const Session& s) { return s.document().time.last_frame; }));
    animate(
        make_room_action, {},
        [](Editor& e) {
            if (const auto time = time_with_room(e.session)) e.session.run(SetTime{*time});
        },
        {[](const Editor& e) { return time_with_room(e.session).has_value(); },
         "nothing is moving in the last frame"},
        true);
    animate(
        timeline_action, {{.key = 'T', .shift = true}},
        [](Editor& e) {
            e.preferences.timeline_open = !e.preferences.timeline_open || e.only_view;
            e.only_view = false;
        },
        {}, true)
        .on = [](const Editor& e) { return e.preferences.timeline_open; };
}

} // namespace trivar
