// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/key_target.h"

#include "core/commands/objects/animate.h"
#include "core/placement/placement.h"
#include "editor/session/session.h"

#include <algorithm>

namespace trivar {
namespace {

bool run_if(Session& session, const std::optional<Command>& command)
{
    return command && !session.proposing() && session.run(*command);
}

// Applies `change` to those tracks.
std::optional<Command> changed_tracks(const Document& document, const KeyTarget& target,
                                      auto&& change)
{
    Animate out;
    for (const Id id : target.ids) {
        ObjectTracks of{id, {}};
        for (const std::string& name : target.names)
            if (const Track* track = track_of(document, id, name))
                of.tracks.push_back(change(*track));
        if (!of.tracks.empty()) out.of.push_back(std::move(of));
    }
    if (out.of.empty()) return {};
    return out;
}

// Returns the size that an automatic size of an object has in the picture; 0: not known.
double shown_size(const Session& session, Id id, const std::string& parameter)
{
    const auto found = session.evaluated().objects.find(id);
    if (found == session.evaluated().objects.end() || !found->second->stroke_placement()) return 0;
    const PlacementReport& report = found->second->stroke_placement()->report;
    if (parameter == "placement.width") return report.width_world;
    return parameter == "placement.height" ? report.height_world : 0;
}

} // namespace

KeyTarget meant_by(const Document& document, KeyTarget target)
{
    const auto has_keys = [&](const std::string& name) {
        return std::ranges::any_of(target.ids, [&](Id id) { return track_of(document, id, name); });
    };
    if (std::ranges::any_of(target.names, has_keys))
        std::erase_if(target.names, [&](const std::string& name) { return !has_keys(name); });
    return target;
}

KeyState state_of_keys(const Session& session, const KeyTarget& target)
{
    const double frame = session.frame();
    bool any = false, all = true;
    const KeyTarget meant = meant_by(session.document(), target);
    for (const Id id : meant.ids)
        for (const std::string& name : meant.names) {
            const Track* track = track_of(session.document(), id, name);
            any = any || track;
            all = all && track && std::ranges::binary_search(track->keys, frame, {}, &Key::frame);
        }
    return !any ? KeyState::none : all ? KeyState::here : KeyState::animated;
}

std::optional<Command> keys_as_shown(const Session& session, const std::vector<Id>& ids,
                                     const std::vector<std::string>& names)
{
    std::optional<Command> keys = keys_of(session.document(), ids, names, session.frame());
    if (!keys) return keys;
    for (ObjectTracks& of : keys->edit<Animate>()->of)
        for (Track& track : of.tracks)
            for (Key& key : track.keys)
                if (key.frame == session.frame() && key.value == 0)
                    key.value = shown_size(session, of.object, track.parameter);
    return keys;
}

bool insert_keys(Session& session, const KeyTarget& target)
{
    const KeyTarget meant = meant_by(session.document(), target);
    return run_if(session, keys_as_shown(session, meant.ids, meant.names));
}

bool remove_keys(Session& session, const KeyTarget& target)
{
    return run_if(session,
                  without_keys(session.document(), target.ids, target.names, session.frame()));
}

bool remove_tracks(Session& session, const KeyTarget& target)
{
    return run_if(session, changed_tracks(session.document(), target, [](const Track& track) {
                      return Track{track.parameter, {}};
                  }));
}

void toggle_keys(Session& session, const KeyTarget& target)
{
    if (state_of_keys(session, target) == KeyState::here)
        remove_keys(session, target);
    else
        insert_keys(session, target);
}

std::optional<Command> tracks_command(const Document& document, const KeyTarget& target)
{
    return changed_tracks(document, target, [](const Track& track) { return track; });
}

} // namespace trivar
