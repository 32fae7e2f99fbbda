// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/files/frames_export.h"
#include "editor/session/session.h"
#include "ui/file_dialog.h"

namespace trivar {

// An ExportPlan holds a person's choices for exporting frames as one file, before it is written.
struct ExportPlan {
    std::string file; // its ending decides what it is
    int first = 1, last = 1;
    double tolerance = 0;   // metres; of a .glb, and of instances; as AnimatedScene::tolerance
    bool instances = false; // in a .usda
    bool operator==(const ExportPlan&) const = default;
};

// An ExportDialog is the dialog in which a person chooses that.
struct ExportDialog {
    bool open = false;
    std::string of; // the scene's file, for which it is
    ExportPlan plan;
    ui::FileDialog browser; // over it
};

// The plan with all frames as a .glb beside the scene, or in `models_folder` where the scene has no
// file; its name is not that of one of the scene's models.
ExportPlan usual_export(const Session& session, const std::string& models_folder);

// The number of the file's kind among animated_extensions(); -1: none of them.
int kind_of(const ExportPlan& plan);
void set_kind(ExportPlan& plan, int kind); // by the ending of its file

// The wish for the present scene. Throws Rejected where the plan makes no sense, in a sentence that
// says what would.
ExportWish wish_of(const ExportPlan& plan, const Session& session);

// An ExportOutlook is the result to expect of a plan, and whether it replaces something.
struct ExportOutlook {
    std::string words;
    bool replaces = false;
};
ExportOutlook outlook_of(const ExportPlan& plan, const ExportWish& wish);

} // namespace trivar
