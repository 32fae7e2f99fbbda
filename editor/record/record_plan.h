// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/record/recording.h"
#include "editor/session/session.h"
#include "gpu/level.h"
#include "ui/file_dialog.h"

#include <optional>
#include <utility>

namespace trivar {

struct FrameNames;
struct RecordingWish;

// A RecordPlan holds a person's choices for a recording, before it begins.
struct RecordPlan {
    std::string folder;
    enum Format { png, png_16, exr } format = png;
    gpu::Level level = gpu::Level::standard;
    int width_px = 1920, height_px = 1080;
    int first = 1, last = 1, step = 1; // frames
    bool video = false;                // a .mp4 in the folder, too
    bool operator==(const RecordPlan&) const = default;
};

// RecordDialog is the state of the dialog in which a person makes them.
struct RecordDialog {
    bool open = false;
    std::string of; // the scene's file, for which it is
    RecordPlan plan;
    // The number of its files that existed when the plan became so: asked once, for it may be a
    // million of them on a slow disk.
    std::optional<std::pair<RecordPlan, int>> there;
    ui::FileDialog browser;   // for the folder
    bool card_hidden = false; // of the recording that runs
};

// All frames of the scene, into a folder of their own beside its file.
RecordPlan usual_plan(const Session& session);

// The pictures' names: those of the scene's file, with the frame's number.
FrameNames names_of(const RecordPlan& plan, const Session& session);
std::string video_of(const RecordPlan& plan, const Session& session); // its file

// The scene as it is now, from the view that is kept for pictures or else the present one. Throws
// Rejected where the plan makes no sense, in a sentence that says what does.
RecordingWish wish_of(const RecordPlan& plan, const Session& session);

} // namespace trivar
