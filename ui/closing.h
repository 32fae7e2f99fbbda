// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace trivar::ui {

// Draws a part of a frame. Where it ends by an exception, closes the windows, menus, tables, fonts
// and styles that it left open, so that the rest of the frame can be drawn, and passes it on.
void draw_closing(const std::function<void()>& draw);

} // namespace trivar::ui
