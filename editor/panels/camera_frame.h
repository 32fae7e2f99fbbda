// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/paint.h"

namespace trivar {

// Returns the part of a view through the render camera that a picture of that size in pixels shows;
// `view` is the rectangle of the view in the window. It lies inside of `view`.
ui::Rect picture_frame(const Camera& render_camera, glm::dvec2 size_px, const ui::Rect& view);

// Frames the part that a picture or a recording will show, and darkens the rest, while the window
// looks through the render camera.
void draw_camera_frame(Editor& editor, const ui::Theme& theme, const ui::Rect& view);

} // namespace trivar
