// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

#include <functional>
#include <string>

namespace trivar {

// A PlanDialog is a dialog in which a person says how files are to be made: rows of fields, below
// them a paragraph on what they give or why they make no sense, and at its foot Cancel and the
// button that begins.
struct PlanDialog {
    const char* title = "";
    int rows = 0;
    std::function<void()> fields = {};         // draws the rows
    std::function<std::string()> come_to = {}; // throws Rejected where the fields make no sense
    std::function<std::string()> begin = {};   // returns the words of the button for these fields
};
enum class PlanAnswer { none, cancelled, begun };
PlanAnswer draw_plan_dialog(const ui::Theme& theme, const PlanDialog& dialog);

// Draws a row for a file or a folder, which can be typed; returns whether the person wants to
// browse. `none` is shown where nothing is typed.
bool draw_path_row(const ui::Theme& theme, const std::string& label, std::string& path,
                   const std::string& none, const std::string& help);
// Draws a row for the first and the last frame, within the scene's, and for the step; null: without
// the step.
void draw_frames_row(const ui::Theme& theme, const Time& time, int& first, int& last, int* step);

} // namespace trivar
