// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/document/parameters.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

constexpr std::size_t most_tracks = 1000, most_keys = 100000;

void check_keys(const Track& track, const Parameter& parameter)
{
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
        const Key& key = track.keys[i];
        if (i > 0 && !(track.keys[i - 1].frame < key.frame))
            throw Rejected(fmt::format("the keys of {} are not in order: frame {} comes after {}",
                                       track.parameter, key.frame, track.keys[i - 1].frame));
        if (!(key.value >= parameter.lo && key.value <= parameter.hi))
            throw Rejected(fmt::format("the key of {} in frame {} is {} but must lie between {} "
                                       "and {}",
                                       track.parameter, key.frame, key.value, parameter.lo,
                                       parameter.hi));
        if (key.before.x > 0 || key.after.x < 0)
            throw Rejected(fmt::format("the handles of {} in frame {} point the wrong way in time",
                                       track.parameter, key.frame));
    }
}

std::vector<Track> merged(std::vector<Track> tracks, const std::vector<Track>& more,
                          const std::vector<Parameter>& known, const std::string& whose)
{
    if (more.empty()) throw Rejected("field \"tracks\" is empty; name a parameter");
    for (const Track& track : more) {
        auto had = std::ranges::lower_bound(tracks, track.parameter, {}, &Track::parameter);
        const bool has = had != tracks.end() && had->parameter == track.parameter;
        if (track.keys.empty()) { // also tracks of parameters that no longer exist
            if (has) tracks.erase(had);
            continue;
        }
        const auto parameter = std::ranges::find(known, track.parameter, &Parameter::name);
        if (parameter == known.end())
            throw Rejected(
                fmt::format("{} has no parameter \"{}\"", whose, excerpt(track.parameter)));
        check_keys(track, *parameter);
        if (!has) had = tracks.insert(had, Track{});
        *had = as_taken(track, *parameter);
    }
    std::size_t keys = 0;
    for (const Track& track : tracks) keys += track.keys.size();
    if (tracks.size() > most_tracks || keys > most_keys)
        throw Rejected(fmt::format(
            "{} would have {} animated parameters with {} keys but at most {} and {} are allowed",
            whose, tracks.size(), keys, most_tracks, most_keys));
    return tracks;
}

} // namespace

Document applied(Document document, const Animate& command)
{
    if (command.of.empty()) throw Rejected("field \"of\" is empty; name an object");
    std::set<Id> seen;
    for (const ObjectTracks& each : command.of) {
        const Id id = each.object;
        if (!seen.insert(id).second)
            throw Rejected(fmt::format("field \"of\" has object {} twice", id));
        if (id == 0)
            document.tracks = make_ref(
                merged(*document.tracks, each.tracks, scene_parameters(document), "the scene"));
        else {
            const std::string whose = named(document, id);
            document = with_changed(std::move(document), id, [&](Object& o) {
                o.tracks = merged(std::move(o.tracks), each.tracks, parameters(o), whose);
            });
        }
    }
    return document;
}

} // namespace trivar
