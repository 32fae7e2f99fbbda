// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/files/frames_export.h"
#include "editor/session/session.h"
#include "ui/file_dialog.h"

namespace trivar {

// What a person says of frames that become one file for other programs, before they are written.
struct ExportPlan {
    std::string file; // its ending decides what it is
    int first = 1, last = 1;
    double tolerance = default_tolerance; // metres; of a .glb alone
    bool operator==(const ExportPlan&) const = default;
};

// Where a person says it.
struct ExportDialog {
    bool open = false;
    std::string of; // the scene's file, for which it is
    ExportPlan plan;
    ui::FileDialog browser; // over it
};

// All frames as a .glb beside the scene, or in that folder where the scene has no file; under no
// name that one of the scene's models has.
ExportPlan usual_export(const Session& session, const std::string& models_folder);

// Among animated_extensions(); -1: none of them.
int kind_of(const ExportPlan& plan);
void set_kind(ExportPlan& plan, int kind); // by the ending of its file

// The scene as it is now. Throws Rejected where the plan makes no sense, in a sentence that says
// what does.
ExportWish wish_of(const ExportPlan& plan, const Session& session);

// What the plan comes to, and whether it takes the place of something.
struct ExportOutlook {
    std::string words;
    bool replaces = false;
};
ExportOutlook outlook_of(const ExportPlan& plan, const ExportWish& wish);

} // namespace trivar
