// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/key_actions.h"

#include "core/commands/objects/animate.h"
#include "core/commands/objects/view.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/hands/parts_tool.h"
#include "editor/session/session_facts.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {

std::vector<std::string> names_of_view(const std::string& view)
{
    std::vector<std::string> out;
    for (const char* part : {"eye", "target"})
        for (const char axis : {'x', 'y', 'z'})
            out.push_back("camera." + view + "." + part + "." + axis);
    out.push_back("camera." + view + ".fov_y");
    return out;
}

namespace {

using Hand = KeyGesture::Hand;

// Returns the selected objects if any of them has keys, else all objects.
std::vector<Id> ids_with_keys(const Editor& e)
{
    const std::vector<Id> all = animated_ids(e.session.document());
    std::vector<Id> chosen;
    for (const Id id : all)
        if (e.session.selected.contains(id)) chosen.push_back(id);
    return chosen.empty() ? all : chosen;
}

void go_to_key(Editor& e, bool forward)
{
    const double now = e.session.frame();
    std::optional<double> best;
    for (const Id id : ids_with_keys(e))
        for (const Track& track : tracks_of(e.session.document(), id))
            for (const Key& key : track.keys)
                if (forward ? key.frame > now && (!best || key.frame < *best)
                            : key.frame < now && (!best || key.frame > *best))
                    best = key.frame;
    e.playback.pause();
    if (best)
        e.session.show_frame(static_cast<int>(forward ? std::ceil(*best) : std::floor(*best)));
}

// Returns the numbers of the parts that the tool has chosen, unless the mouse means something else.
std::optional<std::vector<std::string>> numbers_of_parts(const Editor& e)
{
    if (e.timeline.hovered || !e.keys_under_mouse.empty()) return {};
    const PartsTool* parts = e.tool_parts();
    return parts ? parts->numbers(e.session) : std::nullopt;
}

// Says what became of a key for the parts that the tool has chosen.
void tell_of_parts(Editor& e)
{
    const auto numbers = numbers_of_parts(e);
    if (!numbers) return;
    if (numbers->empty())
        e.session.notices.say(
            ui::NoticeKind::warning, "The selected points have no key",
            "Keys belong to steps. Move these points and no others; that step can then have keys.",
            of_a_step);
    else
        e.session.notices.say(
            ui::NoticeKind::good, "The selected points have a key here",
            fmt::format("The key is in frame {}, in the last step that moved them.",
                        e.session.frame()),
            of_a_step);
}

// Where no number is under the mouse: those of the selected objects that have keys, else where
// they are.
std::vector<KeyTarget> targets(const Editor& e)
{
    const Document& document = e.session.document();
    if (!e.keys_under_mouse.empty()) return {meant_by(document, e.keys_under_mouse)};
    std::vector<KeyTarget> out;
    if (const auto numbers = numbers_of_parts(e)) {
        if (!numbers->empty()) out.push_back({{e.session.selected}, *numbers});
        return out;
    }
    std::vector<Id> ids = e.session.selected.ids();
    if (e.timeline.hovered && ids.empty()) ids = animated_ids(document);
    for (const Id id : ids) {
        KeyTarget one{{id}, {}};
        for (const Track& track : tracks_of(document, id)) one.names.push_back(track.parameter);
        if (one.names.empty() && !object(document, id).stroke)
            for (const char* part : {"translation", "rotation_deg", "scale"})
                for (const char axis : {'x', 'y', 'z'})
                    one.names.push_back(std::string("transform.") + part + "." + axis);
        if (!one.names.empty()) out.push_back(std::move(one));
    }
    if (ids.empty() && document.kept_views.contains("picture"))
        out.push_back({{0}, names_of_view("picture")});
    return out;
}

// Gives the view of pictures keys of the window's view, if the mouse means nothing else.
bool key_view(Editor& e)
{
    if (!e.keys_under_mouse.empty() || !e.session.selected.ids().empty() || e.timeline.hovered ||
        !e.session.document().kept_views.contains("picture") || e.session.proposing())
        return false;
    const Command view = KeepView{"picture", camera_for_pictures(e.session)};
    const Command keys = keyed(e.session.committed(), view, e.session.frame(), true);
    return keys.is<Animate>() && e.session.run(keys);
}

using Change = std::optional<Command> (*)(const Session&, const std::vector<Id>&,
                                          const std::vector<std::string>&);
void change_keys(Editor& e, Change change)
{
    Animate all;
    for (const KeyTarget& target : targets(e))
        if (const auto one = change(e.session, target.ids, target.names))
            for (const ObjectTracks& of : one->get<Animate>().of) all.of.push_back(of);
    if (!all.of.empty() && !e.session.proposing()) e.session.run(all);
}

Condition something_to_key()
{
    return {[](const Editor& e) { return !targets(e).empty(); },
            "hover over a number in the inspector, or select an object that lies on no stroke"};
}

bool keys_take(const Editor& e)
{
    return e.timeline.hovered && e.preferences.timeline_open &&
           !animated_ids(e.session.document()).empty();
}

void choose_all(Editor& e)
{
    KeysView& view = e.timeline.keys;
    view.chosen.clear();
    for (const Id id : animated_ids(e.session.document()))
        for (const Track& track : tracks_of(e.session.document(), id))
            for (const Key& key : track.keys)
                view.chosen.insert({{id, track.parameter}, key.frame});
}

void choose_others(Editor& e)
{
    const ChosenKeys before = e.timeline.keys.chosen;
    choose_all(e);
    std::erase_if(e.timeline.keys.chosen, [&](const KeyName& key) { return before.contains(key); });
}

void delete_chosen(Editor& e)
{
    const KeyEdit edit = without(e.session.committed(), e.timeline.keys.chosen);
    if (edit.command && !e.session.proposing()) e.session.run(*edit.command);
}

} // namespace

void add_key_actions(std::vector<Action>& a)
{
    const Menu animate(a, "Animate");
    animate(
        insert_key_action, {{'I'}},
        [](Editor& e) {
            if (key_view(e)) return;
            change_keys(e, keys_as_shown);
            tell_of_parts(e);
        },
        {[](const Editor& e) { return !targets(e).empty() || numbers_of_parts(e); },
         something_to_key().otherwise},
        true);
    animate(
        remove_key_action, {{.key = 'I', .alt = true}},
        [](Editor& e) {
            change_keys(e, [](const Session& session, const std::vector<Id>& ids,
                              const std::vector<std::string>& names) {
                return without_keys(session.document(), ids, names, session.frame());
            });
        },
        something_to_key());
    const Condition keyed{
        [](const Editor& e) { return !animated_ids(e.session.document()).empty(); },
        "there are no keys"};
    animate(
        next_key_action, {{ui::key_up}}, [](Editor& e) { go_to_key(e, true); }, keyed)
        .keys_in = KeysIn::picture;
    a.back().repeats = true;
    animate(
        previous_key_action, {{ui::key_down}}, [](Editor& e) { go_to_key(e, false); }, keyed)
        .keys_in = KeysIn::picture;
    a.back().repeats = true;
    animate(auto_key_action, {}, [](Editor& e) { e.session.auto_key = !e.session.auto_key; }).on =
        [](const Editor& e) { return e.session.auto_key; };
}

void let_keys_take(std::vector<Action>& actions)
{
    const auto take = [&](const std::string& name, void (*with_keys)(Editor&), bool chosen) {
        const auto found = std::ranges::find(actions, name, &Action::name);
        const auto here = [chosen](const Editor& e) {
            return keys_take(e) && (!chosen || !e.timeline.keys.chosen.empty());
        };
        found->run = [here, with_keys, usual = found->run](Editor& e) {
            here(e) ? with_keys(e) : usual(e);
        };
        if (const auto usual = found->enabled.holds)
            found->enabled.holds = [here, usual](const Editor& e) { return here(e) || usual(e); };
    };
    take("Select all", choose_all, false);
    take(
        "Deselect all", [](Editor& e) { e.timeline.keys.chosen.clear(); }, false);
    take("Invert selection", choose_others, false);
    take("Delete", delete_chosen, true);
    take(
        "Duplicate", [](Editor& e) { e.timeline.keys.asked = Hand::copy; }, true);
    take(
        "Move", [](Editor& e) { e.timeline.keys.asked = Hand::move; }, true);
    take(
        "Scale", [](Editor& e) { e.timeline.keys.asked = Hand::scale; }, true);
    take(
        "Frame selection", [](Editor& e) { e.timeline.keys.fit_chosen = true; }, true);
    take(
        "Frame all",
        [](Editor& e) {
            e.timeline.shown.reset();
            e.timeline.keys.values.reset();
        },
        false);
}

void show_tracks(Editor& editor, const KeyTarget& target)
{
    KeysView& view = editor.timeline.keys;
    editor.preferences.timeline_open = true;
    editor.only_view = false;
    view.tracks.clear();
    for (const Id id : target.ids) {
        view.unfolded.insert(id);
        for (const std::string& name : target.names)
            if (track_of(editor.session.document(), id, name)) view.tracks.insert({id, name});
    }
}

} // namespace trivar
