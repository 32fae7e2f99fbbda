// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Scenes and models in and out.
inline constexpr const char *record_action = "Record...", *import_action = "Import model...";
// The dialog that begins a recording; while one runs, shows or hides how far it is.
void ask_record(Editor& editor);
void ask_export_frames(Editor& editor); // the dialog that begins one
void add_file_actions(std::vector<Action>& actions);

} // namespace trivar
