// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/parameters.h"
#include "editor/timeline/keys_view.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// The rows of the open timeline: what travels, and what has keys, in the order of the outliner,
// the scene first. An object that does both and is unfolded has a row for its travel among those
// of its tracks; folded, the bar of its travel stands behind its keys.
struct TimelineRow {
    enum class Kind { object, travel, track } kind = Kind::object;
    Id id = 0;
    std::string parameter; // of a track
    bool travels = false;  // its bar stands in this row
    TrackName track() const { return {id, parameter}; }
    bool operator==(const TimelineRow&) const = default;
};
std::vector<TimelineRow> timeline_rows(const Document& document, const std::set<Id>& unfolded);

// The parameters that the tracks among the rows move; a track whose number no longer exists has
// none.
using NumbersOfTracks = std::map<TrackName, Parameter>;
NumbersOfTracks numbers_of(const Document& document, const std::vector<TimelineRow>& rows);

// Returns the name of the row: the object, "Scene", or the number in words.
std::string name_of_row(const Document& document, const TimelineRow& row);

// Keys that a row shows at one frame: of a track one, of an object those of all its tracks.
struct KeysAt {
    double frame = 0;
    std::vector<KeyName> keys;
};
std::vector<KeysAt> keys_of_row(const Document& document, const TimelineRow& row);
// The frames of all keys there are, ascending.
std::set<double> key_frames(const Document& document, const std::vector<Id>& ids);
// Returns the frames of the first and of the last of all keys; none if there are no keys.
std::optional<glm::dvec2> keyed_frames(const Document& document);

// Returns the tracks whose curves are shown: those whose rows are chosen, else those of the
// selection, else all.
std::vector<TrackName> shown_curves(const Document& document, const KeysView& view,
                                    const std::vector<Id>& selected);

} // namespace trivar
