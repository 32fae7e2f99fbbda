// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"

#include <functional>
#include <set>
#include <string>

namespace trivar {

// The mistakes of Trivar that were written down, as they are kept in the editor's memory.
struct MistakeReports {
    std::string folder; // of the reports, a file each; empty: none is written
    std::set<std::string> written = {};
    long told_evaluation = 0; // whose failed steps were told
};

// Does a part of a frame: a panel, the keys. What ends it becomes a notice, and a report where it
// is a mistake of Trivar. As it may come again in each frame, the gesture at hand is cancelled and
// the first tool taken; if that was at hand already, nothing stays selected. Where the editor's
// OnFailure says so, as in tests, it is passed on instead. Returns whether the part came to its
// end.
bool do_guarded(Editor& editor, const std::function<void()>& part);

// Tells once of the steps that failed in the session's evaluation.
void tell_failed_steps(Editor& editor);

} // namespace trivar
