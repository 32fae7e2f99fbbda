// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/keying.h"

#include "core/commands/objects/animate.h"
#include "core/document/parameters.h"

#include <algorithm>

namespace trivar {
namespace {

std::vector<Parameter> parameters_of(const Document& document, Id id)
{
    return id == 0 ? scene_parameters(document) : parameters(object(document, id));
}

NewValue values_of(const std::vector<Parameter>& parameters)
{
    return [&parameters](const std::string& name) -> std::optional<double> {
        const auto found = std::ranges::find(parameters, name, &Parameter::name);
        if (found == parameters.end()) return {};
        return found->value;
    };
}

// NumberChanges are the numbers that differ between two lists of parameters; there are none if the
// names differ.
struct NumberChanges {
    std::vector<std::string> names;
    std::vector<double> values;
};
std::optional<NumberChanges> changed(const std::vector<Parameter>& before,
                                     const std::vector<Parameter>& after)
{
    if (!std::ranges::equal(before, after, {}, &Parameter::name, &Parameter::name)) return {};
    NumberChanges out;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].value != after[i].value) {
            out.names.push_back(after[i].name);
            out.values.push_back(after[i].value);
        }
    return out;
}

bool same_scene_but_for_objects(const Document& a, const Document& b)
{
    return *a.rows == *b.rows && a.time == b.time && a.next_id == b.next_id &&
           a.objects.size() == b.objects.size() && *a.tracks == *b.tracks;
}

} // namespace

Command keyed(const Document& document, const Command& command, double frame, bool always)
{
    if (command.is<Animate>()) return command;
    const Document now = document_at(document, frame), made = after(now, command);
    if (!same_scene_but_for_objects(now, made)) return command;
    Animate out;
    bool tracked = always;
    const auto add = [&](Id id, const std::vector<Parameter>& before,
                         const std::vector<Parameter>& then) {
        const auto change = changed(before, then);
        if (!change) return false;
        ObjectTracks of{id, {}};
        for (std::size_t i = 0; i < change->names.size(); ++i) {
            const Track* had = track_of(document, id, change->names[i]);
            tracked = tracked || had;
            of.tracks.push_back(
                with_key(had ? *had : Track{change->names[i], {}}, frame, change->values[i]));
        }
        if (!of.tracks.empty()) out.of.push_back(std::move(of));
        return true;
    };
    const std::vector<Parameter> scene = scene_parameters(now);
    if (!add(0, scene, scene_parameters(made))) return command;
    const Document same = with_scene_values(made, values_of(scene));
    if (*same.render != *now.render || same.kept_views != now.kept_views) return command;
    for (const auto& [id, each] : made.objects) {
        const auto was = now.objects.find(id);
        if (was == now.objects.end()) return command;
        if (was->second == each) continue;
        const std::vector<Parameter> before = parameters(*was->second);
        if (!add(id, before, parameters(*each))) return command;
        Object rest = with_values(*each, values_of(before));
        if (!std::ranges::equal(rest.shaping, was->second->shaping,
                                [](const auto& a, const auto& b) { return *a == *b; }))
            return command;
        rest.shaping = was->second->shaping; // whose elements only differ in their pointers
        if (rest != *was->second) return command;
    }
    if (!tracked || out.of.empty()) return command;
    return out;
}

std::optional<Command> keys_of(const Document& document, const std::vector<Id>& ids,
                               const std::vector<std::string>& names, double frame)
{
    const Document now = document_at(document, frame);
    Animate out;
    for (const Id id : ids) {
        ObjectTracks of{id, {}};
        for (const Parameter& p : parameters_of(now, id)) {
            if (std::ranges::find(names, p.name) == names.end()) continue;
            const Track* had = track_of(document, id, p.name);
            of.tracks.push_back(with_key(had ? *had : Track{p.name, {}}, frame, p.value));
        }
        if (!of.tracks.empty()) out.of.push_back(std::move(of));
    }
    if (out.of.empty()) return {};
    return out;
}

std::optional<Command> without_keys(const Document& document, const std::vector<Id>& ids,
                                    const std::vector<std::string>& names, double frame)
{
    Animate out;
    for (const Id id : ids) {
        ObjectTracks of{id, {}};
        for (Track track : tracks_of(document, id))
            if (std::ranges::find(names, track.parameter) != names.end() &&
                std::erase_if(track.keys, [&](const Key& key) { return key.frame == frame; }) > 0)
                of.tracks.push_back(std::move(track));
        if (!of.tracks.empty()) out.of.push_back(std::move(of));
    }
    if (out.of.empty()) return {};
    return out;
}

const std::vector<Track>& tracks_of(const Document& document, Id id)
{
    return id == 0 ? *document.tracks : object(document, id).tracks.all();
}

const Track* track_of(const Document& document, Id id, const std::string& parameter)
{
    const std::vector<Track>& tracks = tracks_of(document, id);
    const auto found = std::ranges::lower_bound(tracks, parameter, {}, &Track::parameter);
    return found != tracks.end() && found->parameter == parameter ? &*found : nullptr;
}

std::vector<Id> animated_ids(const Document& document)
{
    std::vector<Id> out;
    if (!document.tracks->empty()) out.push_back(0);
    for (const Id id : in_row_order(document))
        if (!object(document, id).tracks.empty()) out.push_back(id);
    return out;
}

} // namespace trivar
