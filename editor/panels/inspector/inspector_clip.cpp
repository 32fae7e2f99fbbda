// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/objects/play.h"
#include "core/stages/walk.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <optional>

namespace trivar {
namespace {

// Returns the clips that every one of them can play, in the order of the active one's file.
std::vector<std::string> common_clips(const Evaluation& evaluated, const std::vector<Id>& ids)
{
    const auto clips_of = [&](Id id) {
        const auto found = evaluated.objects.find(id);
        return found == evaluated.objects.end() ? std::vector<std::string>{} : found->second->clips;
    };
    std::vector<std::string> out = clips_of(ids.back());
    std::erase_if(out, [&](const std::string& clip) {
        return std::ranges::any_of(ids, [&](Id id) {
            const std::vector<std::string> its = clips_of(id);
            return std::ranges::find(its, clip) == its.end();
        });
    });
    return out;
}

// The clip that a hand took, if one did; empty: none, it stands.
std::optional<std::string> clip_row(ValueRows& rows, const std::string& now,
                                    std::vector<std::string> clips, bool mixed)
{
    if (!now.empty() && std::ranges::find(clips, now) == clips.end())
        clips.insert(clips.begin(), now); // of a file that is not there
    std::vector<std::string> words{"None"};
    words.insert(words.end(), clips.begin(), clips.end());
    clips.insert(clips.begin(), "");
    if (mixed) { // is shown; to take it changes nothing
        words.insert(words.begin(), "mixed");
        clips.insert(clips.begin(), now);
    }
    const int none = mixed ? 1 : 0;
    const auto shown = static_cast<int>(mixed ? 0 : std::ranges::find(clips, now) - clips.begin());
    int chosen = shown;
    rows.row("Clip", chosen, none, without_unit(facts_of(&Playing::clip).help).c_str(),
             [&](float width) { return ui::choice(rows.theme, "clip", chosen, words, width); });
    if (chosen == shown) return std::nullopt;
    return clips[static_cast<std::size_t>(chosen)];
}

Ref<Walk> walk_of(const Evaluation& evaluated, Id id)
{
    const auto found = evaluated.objects.find(id);
    return found == evaluated.objects.end() ? nullptr : found->second->walk;
}

std::string of_stride(double share)
{
    return percent_text(share) + " of a stride";
}

} // namespace

void draw_clip(Editor& editor, const ui::Theme& theme, const std::vector<Id>& ids)
{
    const Document& document = editor.session.document();
    std::vector<Playing> all;
    for (const Id id : ids) all.push_back(object(document, id).playing);
    const Playing before = all.back(); // the active one's, from which a drag begins
    const std::vector<std::string> clips = common_clips(editor.session.evaluated(), ids);
    if (clips.empty() && before.clip.empty()) return;
    if (!ui::section(theme, "Clip")) return;
    Playing p = before;
    const KeyGutter keys(editor, ids);
    ValueRows rows{theme, &keys};
    FieldRows<Playing> fields(rows, p, "playing", all);
    const bool mixed =
        std::ranges::any_of(all, [&](const Playing& each) { return each.clip != before.clip; });
    const std::optional<std::string> taken = clip_row(rows, before.clip, clips, mixed);
    if (taken) p.clip = *taken;
    const bool laid =
        std::ranges::all_of(ids, [&](Id id) { return object(document, id).stroke.has_value(); });
    const Ref<Walk> walk =
        ids.size() == 1 ? walk_of(editor.session.evaluated(), ids.back()) : nullptr;
    const bool walks = walk && walk->trouble.empty();
    ui::rows_if(theme, !p.clip.empty(), "No clip is played.", [&] {
        ui::rows_if(theme, laid || p.foot_lock, "It is not placed on a stroke.",
                    [&] { fields(&Playing::foot_lock); });
        ui::rows_if(theme, walks, "Its feet are not locked.", [&] {
            ui::fact_row(theme, "Feet slide", walks ? of_stride(*walk->slide) : "");
            ui::fact_row(theme, "Feet moved", walks ? of_stride(walk->correction) : "");
            ui::fact_row(theme, "Own speed",
                         walks ? ui::short_number(walk->natural_speed) + " m/s" : "");
        });
        const auto own_pace = [&](const std::function<void()>& draw) {
            ui::rows_if(theme, !p.foot_lock, "Its feet are locked, so its way sets the pace.",
                        draw);
        };
        own_pace([&] {
            fields(&Playing::speed);
            fields(&Playing::repeat);
        });
        fields(&Playing::offset);
        own_pace([&] { fields.resting_at(document.time.first_frame, &Playing::start_frame); });
    });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        if (ids.size() == 1) return PlayClip{ids, p};
        for (Playing& each : all) {
            if (taken) each.clip = *taken; // also where it is the active one's
            fields.put_into(each);
        }
        return PlayClip{ids, {}, all};
    });
}

} // namespace trivar
