// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/widgets.h"

#include <functional>

namespace trivar {

// The parts of the inspector share these functions: a change is proposed while the hand is on it
// and becomes one step when the hand lets go.

// Proposes the command if the edit changed something, or cancels what was proposed before.
void propose_edit(Editor& editor, ui::Edit edit, const std::function<Command()>& command);

// Copies the line of the log that sets the scene's present value to the clipboard.
void copy_command(Editor& editor, const Command& command);

// Draws three fields beside each other, X, Y and Z, in a row of that width, in pixels.
using AxisField = std::function<ui::Edit(int axis, const ui::NumberStyle& style, float width)>;
ui::Edit axis_fields(const ui::Theme& theme, float width, ui::NumberStyle style,
                     const AxisField& field);

// The section of the materials of these objects, but of those that hold others.
void draw_materials(Editor& editor, const ui::Theme& theme, std::vector<Id> ids);
// Draws how large they are, and of how much they are made.
void shape_rows(const Session& session, const ui::Theme& theme, const std::vector<Id>& ids);

// A row for an object whose host was deleted, with the choice of another one.
void bind_row(Editor& editor, const ui::Theme& theme, const char* label, Id id);

// Whether far parts of the volume meet, as far as that is proven; null: it has none now.
void overlap_row(Editor& editor, const ui::Theme& theme, const EvaluatedObject* placed);

// Commits the proposal once no field is held any more; called every frame, after all panels.
void finish_edit(Editor& editor);

} // namespace trivar
