// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keying.h"

#include <compare>
#include <functional>
#include <set>
#include <string>

namespace trivar {

// A track of an object, 0: of the scene; and one of its keys.
struct TrackName {
    Id id = 0;
    std::string parameter;
    auto operator<=>(const TrackName&) const = default;
};
struct KeyName {
    TrackName track;
    double frame = 0;
    auto operator<=>(const KeyName&) const = default;
};
using ChosenKeys = std::set<KeyName>;

// The keys among them that exist.
ChosenKeys present_keys(const Document& document, ChosenKeys keys);
const Track* track_of(const Document& document, const TrackName& name);
const Key* key_of(const Document& document, const KeyName& name);

// A KeyEdit is the result of an edit of keys: the command, if there is anything to do, and the
// names of the same keys afterwards. A moved key replaces a key in its new frame, and a value
// beyond its range becomes the range's end. Tracks of missing parameters stay.
struct KeyEdit {
    std::optional<Command> command;
    ChosenKeys keys;
};
// `value`: by how much those of a track go up.
using TrackRise = std::function<double(const TrackName&)>;
KeyEdit moved(const Document& document, const ChosenKeys& keys, double frames,
              const TrackRise& value = {});
KeyEdit copied(const Document& document, const ChosenKeys& keys, double frames);
// Keys scaled in time about a frame, to whole frames; a negative factor reverses them.
KeyEdit scaled(const Document& document, const ChosenKeys& keys, double about, double factor);
KeyEdit without(const Document& document, const ChosenKeys& keys);
KeyEdit with_tween(const Document& document, const ChosenKeys& keys, Tween tween);
KeyEdit with_value(const Document& document, const ChosenKeys& keys, double value);
// Handles chosen so that the curve is smooth.
KeyEdit smoothed(const Document& document, const ChosenKeys& keys);
// Sets the behaviour after the last key of each of their tracks.
KeyEdit with_repeat(const Document& document, const ChosenKeys& keys, Repeat repeat);

// A key's curve handle, put to [frame, value], no further than the other key. The opposite handle
// turns with it and keeps its length, unless `alone`.
enum class KeyHandle { before, after };
KeyEdit with_handle(const Document& document, const KeyName& key, KeyHandle which, glm::dvec2 to,
                    bool alone);

} // namespace trivar
