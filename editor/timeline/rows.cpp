// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/rows.h"

#include "core/commands/words/number_words.h"
#include "core/document/parameters.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <map>

namespace trivar {

std::vector<TimelineRow> timeline_rows(const Document& document, const std::set<Id>& unfolded)
{
    using Kind = TimelineRow::Kind;
    const std::vector<Id> travel = travelling(document), animated = animated_ids(document);
    std::vector<Id> ids = in_row_order(document);
    ids.insert(ids.begin(), 0);
    std::vector<TimelineRow> out;
    for (const Id id : ids) {
        const bool travels = std::ranges::find(travel, id) != travel.end(),
                   has_keys = std::ranges::find(animated, id) != animated.end(),
                   open = has_keys && unfolded.contains(id);
        if (!travels && !has_keys) continue;
        out.push_back({Kind::object, id, {}, travels && !open});
        if (!open) continue;
        if (travels) out.push_back({Kind::travel, id, {}, true});
        for (const Track& track : tracks_of(document, id))
            out.push_back({Kind::track, id, track.parameter, false});
    }
    return out;
}

NumbersOfTracks numbers_of(const Document& document, const std::vector<TimelineRow>& rows)
{
    NumbersOfTracks out;
    std::vector<Parameter> known; // of the object of that id
    std::optional<Id> of;
    for (const TimelineRow& row : rows) {
        if (row.kind != TimelineRow::Kind::track) continue;
        if (of != row.id)
            known = row.id == 0 ? scene_parameters(document) : parameters(object(document, row.id));
        of = row.id;
        const auto found = std::ranges::find(known, row.parameter, &Parameter::name);
        if (found != known.end()) out.emplace(row.track(), *found);
    }
    return out;
}

std::string name_of_row(const Document& document, const TimelineRow& row)
{
    if (row.kind == TimelineRow::Kind::travel) return "Travel";
    if (row.kind == TimelineRow::Kind::track) return words_of_number(row.parameter).label;
    return row.id == 0 ? "Scene" : name_of(document, row.id);
}

std::vector<KeysAt> keys_of_row(const Document& document, const TimelineRow& row)
{
    std::map<double, std::vector<KeyName>> by_frame;
    if (row.kind == TimelineRow::Kind::travel) return {};
    for (const Track& track : tracks_of(document, row.id))
        if (row.kind == TimelineRow::Kind::object || track.parameter == row.parameter)
            for (const Key& key : track.keys)
                by_frame[key.frame].push_back({{row.id, track.parameter}, key.frame});
    std::vector<KeysAt> out;
    for (auto& [frame, keys] : by_frame) out.push_back({frame, std::move(keys)});
    return out;
}

std::set<double> key_frames(const Document& document, const std::vector<Id>& ids)
{
    std::set<double> out;
    for (const Id id : ids)
        for (const Track& track : tracks_of(document, id))
            for (const Key& key : track.keys) out.insert(key.frame);
    return out;
}

std::optional<glm::dvec2> keyed_frames(const Document& document)
{
    std::optional<glm::dvec2> out;
    for (const Id id : animated_ids(document))
        for (const Track& track : tracks_of(document, id)) {
            if (track.keys.empty()) continue;
            const double first = track.keys.front().frame, last = track.keys.back().frame;
            out = out ? glm::dvec2(std::min(out->x, first), std::max(out->y, last))
                      : glm::dvec2(first, last);
        }
    return out;
}

std::vector<TrackName> shown_curves(const Document& document, const KeysView& view,
                                    const std::vector<Id>& selected)
{
    std::vector<TrackName> all, of_selected, chosen;
    for (const Id id : animated_ids(document))
        for (const Track& track : tracks_of(document, id)) {
            const TrackName name{id, track.parameter};
            all.push_back(name);
            if (std::ranges::find(selected, id) != selected.end()) of_selected.push_back(name);
            if (view.tracks.contains(name)) chosen.push_back(name);
        }
    return !chosen.empty() ? chosen : !of_selected.empty() ? of_selected : all;
}

} // namespace trivar
