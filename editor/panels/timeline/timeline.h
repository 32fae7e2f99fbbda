// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/panels.h"
#include "editor/timeline/rows.h"
#include "editor/timeline/travel_time.h"

namespace trivar {

// The parts of the timeline share these functions.

// A FrameScale says where frames stand, in pixels.
struct FrameScale {
    float lo = 0, hi = 0;       // places of the first and the last shown frame
    double first = 0, last = 0; // those frames
    Time time;
    // frames that can be shown: those of the scene, and from the first to the last key
    glm::dvec2 all{0};
    // the first and the last key, where there are any
    std::optional<glm::dvec2> keys = std::nullopt;
    float x(double frame) const;
    double frame_at(float x) const;
};

// The boundary in the open timeline between names and tracks, and the scale of the tracks.
float names_end(const ui::Theme& theme, const ui::Rect& timeline);
FrameScale track_scale(const ui::Theme& theme, const ui::Rect& timeline, const Editor& editor);

// The shown frames after the wheel has turned `notches` notches over that frame, or rolled as many
// sideways: at least ten, at most all.
glm::dvec2 zoomed_frames(glm::dvec2 shown, glm::dvec2 all, double frame, double notches);
glm::dvec2 rolled_frames(glm::dvec2 shown, glm::dvec2 all, double notches);
// The shown frames as the timeline remembers them: empty where they are the scene's, which may
// change.
std::optional<glm::dvec2> kept_frames(glm::dvec2 shown, const Time& time);

// Draws marks in the ruler, where there are keys before or after the shown frames: a click shows
// them too.
void draw_marks_of_keys(Editor& editor, const ui::Theme& theme, const ui::Rect& ruler,
                        const FrameScale& scale);

// Draws a row for each travelling object and each object with keys, which are chosen and dragged
// there.
void draw_key_rows(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                   const ui::Rect& tracks, const FrameScale& scale);
// Draws the names of rows from that height on, with or without the arrows that fold them; returns
// where they end.
float draw_row_names(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                     const std::vector<TimelineRow>& rows, float y, bool folds);
// Draws the bar of a travelling object in its row: it can be dragged where `by_hand` (keys over it
// are dragged instead), and so can its end.
void draw_travel_bar(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
                     const FrameScale& scale, Id id, bool by_hand);
void let_go_of_bar(Editor& editor);

// Draws the curves of the chosen tracks, in place of the rows.
void draw_curves(Editor& editor, const ui::Theme& theme, const ui::Rect& names,
                 const ui::Rect& tracks, const FrameScale& scale);

// Draws the numbers of the chosen keys, and their tweens, at the right of the transport.
void draw_key_numbers(Editor& editor, const ui::Theme& theme, const ui::Rect& place);

} // namespace trivar
