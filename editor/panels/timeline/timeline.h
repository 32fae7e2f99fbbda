// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/panels.h"
#include "editor/timeline/rows.h"
#include "editor/timeline/travel_time.h"

namespace trivar {

// What the parts of the timeline share.

// Where frames stand, in pixels.
struct FrameScale {
    float lo = 0, hi = 0;       // of the first and the last frame that are shown
    double first = 0, last = 0; // those frames
    Time time;
    glm::dvec2 all{0}; // frames that can be shown: the scene's, and from the first to the last key
    std::optional<glm::dvec2> keys = std::nullopt; // the first and the last, where there are any
    float x(double frame) const;
    double frame_at(float x) const;
};

// Where the open timeline parts its names from its tracks, and where frames stand in these.
float names_end(const ui::Theme& theme, const ui::Rect& timeline);
FrameScale track_scale(const ui::Theme& theme, const ui::Rect& timeline, const Editor& editor);

// The frames that are shown when the wheel has turned so many notches over that frame, or rolled
// so many sideways: not less than ten, not more than all.
glm::dvec2 zoomed_frames(glm::dvec2 shown, glm::dvec2 all, double frame, double notches);
glm::dvec2 rolled_frames(glm::dvec2 shown, glm::dvec2 all, double notches);
// As the timeline remembers them: none where they are the scene's, whatever becomes of these.
std::optional<glm::dvec2> kept_frames(glm::dvec2 shown, const Time& time);

// In the ruler, where there are keys before or after what is shown: marks that show them too.
void draw_marks_of_keys(Editor& editor, const ui::Theme& theme, const ui::Rect& ruler,
                        const FrameScale& scale);

// A row for what travels and for what has keys, which are chosen and dragged there.
void draw_key_rows(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                   const ui::Rect& tracks, const FrameScale& scale);
// The names of rows from that height on, with or without what folds them; returns where they end.
float draw_row_names(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                     const std::vector<TimelineRow>& rows, float y, bool folds);
// In its row: when the object travels, to be dragged, and the end of that.
void draw_travel_bar(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
                     const FrameScale& scale, Id id);
void let_go_of_bar(Editor& editor);

// The curves of what is chosen, in place of the rows' tracks.
void draw_curves(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                 const ui::Rect& tracks, const FrameScale& scale);

// The numbers of the chosen keys, and how they go on, at the right of the transport from there on.
void draw_key_numbers(Editor& editor, const ui::Theme& theme, const ui::Rect& place);

} // namespace trivar
