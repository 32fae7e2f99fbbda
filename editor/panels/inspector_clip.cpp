// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/field_words.h"
#include "editor/panels/inspect.h"
#include "editor/panels/panels.h"
#include "editor/panels/value_rows.h"

#include <algorithm>

namespace trivar {
namespace {

std::string help_of_clip(const char* field)
{
    return help_of_field("play_clip", field);
}

// What every one of them can play, in the order of the active one's file.
std::vector<std::string> common_clips(const Evaluated& evaluated, const std::vector<Id>& ids)
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

void clip_row(ValueRows& rows, Playing& playing, std::vector<std::string> clips, bool mixed)
{
    if (!playing.clip.empty() && std::ranges::find(clips, playing.clip) == clips.end())
        clips.insert(clips.begin(), playing.clip); // of a file that is not there
    clips.insert(clips.begin(), mixed ? "Mixed" : "None");
    auto chosen = static_cast<int>(
        mixed || playing.clip.empty() ? 0 : std::ranges::find(clips, playing.clip) - clips.begin());
    rows.row("Clip", chosen, 0, help_of_clip("clip"),
             [&](float width) { return ui::choice(rows.theme, "clip", chosen, clips, width); });
    if (chosen > 0) playing.clip = clips[static_cast<std::size_t>(chosen)];
    if (chosen == 0 && rows.edit == ui::Edit::changed) playing.clip.clear();
}

void repeat_row(ValueRows& rows, Repeat& repeat)
{
    int chosen = static_cast<int>(repeat);
    rows.row("Repeat", chosen, static_cast<int>(Playing{}.repeat), help_of_clip("repeat"),
             [&](float width) {
                 return ui::choice(rows.theme, "repeat", chosen, {"Once", "Loop", "Back and forth"},
                                   width);
             });
    repeat = static_cast<Repeat>(chosen);
}

} // namespace

void draw_clip(Editor& editor, const ui::Theme& theme, const std::vector<Id>& ids)
{
    const Document& document = editor.session.document();
    std::vector<Playing> all;
    for (const Id id : ids) all.push_back(object(document, id).playing);
    const Playing rest, before = all.back(); // the active one's, from which a drag begins
    const std::vector<std::string> clips = common_clips(editor.session.evaluated(), ids);
    if (clips.empty() && before.clip.empty()) return;
    if (!ui::section(theme, "Clip")) return;
    const auto differs = [&](auto Playing::*part) {
        return std::ranges::any_of(all,
                                   [&](const Playing& each) { return each.*part != before.*part; });
    };
    const auto style = [&](auto Playing::*part, ui::NumberStyle own) {
        if (differs(part)) own.words = "mixed";
        return own;
    };
    Playing p = before;
    ValueRows rows{theme};
    clip_row(rows, p, clips, differs(&Playing::clip));
    if (!p.clip.empty()) {
        rows.number("Speed", p.speed, rest.speed,
                    style(&Playing::speed, {.lo = -1e3, .hi = 1e3, .unit = "x"}),
                    help_of_clip("speed"));
        repeat_row(rows, p.repeat);
        rows.number("Offset", p.offset, rest.offset,
                    style(&Playing::offset, {.lo = -1e6, .hi = 1e6, .unit = "s"}),
                    help_of_clip("offset"));
        rows.integer("Begins", p.start_frame, document.time.first_frame,
                     style(&Playing::start_frame, {.lo = -999999, .hi = 999999, .unit = "frame"}),
                     help_of_clip("start_frame"));
    }
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] {
        if (ids.size() == 1) return PlayClip{ids, p};
        for (Playing& each : all) { // what a hand changed of one, in each of them
            const auto take = [&](auto Playing::*part) {
                if (before.*part != p.*part) each.*part = p.*part;
            };
            take(&Playing::clip);
            take(&Playing::speed);
            take(&Playing::repeat);
            take(&Playing::offset);
            take(&Playing::start_frame);
        }
        return PlayClip{ids, {}, all};
    });
}

} // namespace trivar
