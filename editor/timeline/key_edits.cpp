// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/key_edits.h"

#include "core/commands/objects/animate.h"
#include "core/document/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace trivar {
namespace {

constexpr double farthest_frame = 1e6;

std::vector<Parameter> numbers_of(const Document& document, Id id)
{
    if (id == 0) return scene_parameters(document);
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? std::vector<Parameter>{} : parameters(*found->second);
}

// A TrackChange changes the keys of a track, of which those at `frames` are chosen, and the frames.
using TrackChange =
    std::function<void(Id id, Track& track, std::set<double>& frames, const Parameter& range)>;

KeyEdit changed_tracks_of(const Document& document, const ChosenKeys& keys,
                          const TrackChange& change)
{
    std::map<Id, std::map<std::string, std::set<double>>> by_track;
    for (const KeyName& key : keys) by_track[key.track.id][key.track.parameter].insert(key.frame);
    KeyEdit out;
    Animate animate;
    for (auto& [id, tracks] : by_track) {
        if (id != 0 && !document.objects.contains(id)) continue;
        const std::vector<Parameter> numbers = numbers_of(document, id);
        ObjectTracks of{id, {}};
        for (auto& [name, frames] : tracks) {
            const Track* had = track_of(document, id, name);
            if (!had) continue;
            Track track = *had;
            const auto range = std::ranges::find(numbers, name, &Parameter::name);
            const bool lost = range == numbers.end();
            change(id, track, frames, lost ? Parameter{name, 0, -1e300, 1e300} : *range);
            if (!lost) track = as_taken(std::move(track), *range);
            const bool can_be = !lost || track.keys.empty(); // what is lost can only go
            if (can_be && track != *had) of.tracks.push_back(track);
            for (const double frame : frames)
                if (const KeyName name_now{{id, name}, frame}; std::ranges::binary_search(
                        (can_be ? track : *had).keys, frame, {}, &Key::frame))
                    out.keys.insert(name_now);
        }
        if (!of.tracks.empty()) animate.of.push_back(std::move(of));
    }
    if (!animate.of.empty()) out.command = std::move(animate);
    return out;
}

// Each chosen key as `change` has it; with `stay` those that were there stay as well.
KeyEdit changed_keys(const Document& document, const ChosenKeys& keys,
                     const std::function<Key(Key, const TrackName&)>& change, bool stay = false)
{
    return changed_tracks_of(
        document, keys, [&](Id id, Track& track, std::set<double>& frames, const Parameter& range) {
            const TrackName name{id, track.parameter};
            std::map<double, Key> by_frame;
            for (const Key& key : track.keys)
                if (stay || !frames.contains(key.frame)) by_frame[key.frame] = key;
            std::set<double> now;
            for (Key key : track.keys) {
                if (!frames.contains(key.frame)) continue;
                key = change(key, name);
                key.frame = std::clamp(key.frame, -farthest_frame, farthest_frame);
                key.value = std::clamp(key.value, range.lo, range.hi);
                by_frame[key.frame] = key;
                now.insert(key.frame);
            }
            track.keys.clear();
            for (const auto& [frame, key] : by_frame) track.keys.push_back(key);
            frames = std::move(now);
        });
}

// Returns the tween of a chosen key when the chosen keys of its track are reversed: each piece
// between two of them keeps its tween, and so does the one after the last.
Tween tween_turned(const Document& document, const ChosenKeys& keys, const KeyName& key)
{
    auto before = keys.find(key);
    if (before == keys.begin() || std::prev(before)->track != key.track)
        before = std::prev(keys.upper_bound({key.track, std::numeric_limits<double>::infinity()}));
    else
        --before;
    return key_of(document, *before)->tween;
}

} // namespace

const Track* track_of(const Document& document, const TrackName& name)
{
    if (name.id != 0 && !document.objects.contains(name.id)) return nullptr;
    return track_of(document, name.id, name.parameter);
}

const Key* key_of(const Document& document, const KeyName& name)
{
    const Track* track = track_of(document, name.track);
    if (!track) return nullptr;
    const auto found = std::ranges::lower_bound(track->keys, name.frame, {}, &Key::frame);
    return found != track->keys.end() && found->frame == name.frame ? &*found : nullptr;
}

ChosenKeys present_keys(const Document& document, ChosenKeys keys)
{
    std::erase_if(keys, [&](const KeyName& key) { return !key_of(document, key); });
    return keys;
}

KeyEdit moved(const Document& document, const ChosenKeys& keys, double frames,
              const TrackRise& value)
{
    return changed_keys(document, keys, [&](Key key, const TrackName& track) {
        key.frame += frames;
        if (value) key.value += value(track);
        return key;
    });
}

KeyEdit copied(const Document& document, const ChosenKeys& keys, double frames)
{
    return changed_keys(
        document, keys,
        [&](Key key, const TrackName&) {
            key.frame += frames;
            return key;
        },
        true);
}

KeyEdit scaled(const Document& document, const ChosenKeys& keys, double about, double factor)
{
    return changed_keys(document, keys, [&](Key key, const TrackName& track) {
        if (factor < 0) key.tween = tween_turned(document, keys, {track, key.frame});
        key.frame = std::round(about + (key.frame - about) * factor);
        key.before.x *= factor;
        key.after.x *= factor;
        if (factor < 0) std::swap(key.before, key.after);
        if (factor == 0) key.before = key.after = glm::dvec2(0);
        return key;
    });
}

KeyEdit without(const Document& document, const ChosenKeys& keys)
{
    return changed_tracks_of(
        document, keys, [](Id, Track& track, std::set<double>& frames, const Parameter&) {
            std::erase_if(track.keys, [&](const Key& key) { return frames.contains(key.frame); });
        });
}

KeyEdit with_tween(const Document& document, const ChosenKeys& keys, Tween tween)
{
    return changed_keys(document, keys, [&](Key key, const TrackName&) {
        key.tween = tween;
        return key;
    });
}

KeyEdit with_value(const Document& document, const ChosenKeys& keys, double value)
{
    return changed_keys(document, keys, [&](Key key, const TrackName&) {
        key.value = value;
        return key;
    });
}

KeyEdit smoothed(const Document& document, const ChosenKeys& keys)
{
    return changed_keys(document, keys, [](Key key, const TrackName&) {
        key.before = key.after = glm::dvec2(0);
        return key;
    });
}

KeyEdit with_repeat(const Document& document, const ChosenKeys& keys, Repeat repeat)
{
    return changed_tracks_of(
        document, keys,
        [&](Id, Track& track, std::set<double>&, const Parameter&) { track.repeat = repeat; });
}

KeyEdit with_handle(const Document& document, const KeyName& name, KeyHandle which, glm::dvec2 to,
                    bool alone)
{
    constexpr double least = 1e-3; // frames: of none the handle would choose itself
    return changed_tracks_of(
        document, {name}, [&](Id, Track& track, std::set<double>&, const Parameter&) {
            const auto at = std::ranges::find(track.keys, name.frame, &Key::frame);
            if (at == track.keys.end()) return;
            const auto k = static_cast<std::size_t>(at - track.keys.begin());
            const bool has_after = k + 1 < track.keys.size(), has_before = k > 0;
            const double way = which == KeyHandle::after
                                   ? (has_after ? track.keys[k + 1].frame - at->frame : 0)
                                   : (has_before ? track.keys[k - 1].frame - at->frame : 0);
            if (way == 0) return;
            // The opposite handle as it is now, also if it is automatic.
            glm::dvec2 opposite(0);
            if (which == KeyHandle::after && has_before) {
                const TweenCurve curve = curve_between(track, k - 1);
                opposite = curve.p2 - curve.p3;
            } else if (which == KeyHandle::before && has_after) {
                const TweenCurve curve = curve_between(track, k);
                opposite = curve.p1 - curve.p0;
            }
            glm::dvec2 own = to - glm::dvec2(at->frame, at->value);
            own.x = way > 0 ? std::clamp(own.x, least, way) : std::clamp(own.x, way, -least);
            if (!alone && opposite.x != 0) opposite.y = opposite.x * own.y / own.x;
            (which == KeyHandle::after ? at->after : at->before) = own;
            if (opposite.x != 0) (which == KeyHandle::after ? at->before : at->after) = opposite;
        });
}

} // namespace trivar
