// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/scene/files_read.h"
#include "core/scene/log.h"
#include "core/steps/lacking.h"
#include "editor/command_line/interrupts.h"
#include "editor/command_line/status.h"

#include <map>

namespace trivar {

// A SceneLog is the input of a command: the scene's file, and replacements for files that it names.
struct SceneLog {
    std::string path;
    std::vector<std::string> relinked; // NAME=FILE, as for --set
    bool keep_going = false;           // even where the scene lacks something
    bool overwrite = false;            // even files from which the scene is made
};

// NAME=FILE, as --set has it. Throws WrongUsage.
std::map<std::string, std::string> relinked_files(const std::vector<std::string>& settings);
Ref<AssetStore> asset_store(const SceneLog& scene);
// Throws Rejected unless each relinked name is one that the scene uses and each file exists.
void check_relinked(const SceneLog& scene, const Document& document);

// The files that the output may not replace; empty with --overwrite.
SourceFiles kept_sources(const SceneLog& scene, const Document& document, const AssetStore& assets);
// Ends a command where the scene lacks something, unless --keep-going was given. Throws
// IncompleteScene.
void check_whole(const SceneLog& scene, const Evaluation& evaluated, const Document& document);
void say_not_whole(const SceneLog& scene, const Streams& streams);

// Throws Rejected where the name of an output belongs to something that is no ordinary file.
void check_written(const std::vector<std::string>& paths);

// The text of an ordinary file. Throws Rejected.
std::string log_text(const SceneLog& scene);
// The lines of that text; its notice is written. Throws Rejected.
Log scene_log(const std::string& text, const std::string& path, const Streams& streams);

// Writes one line of progress in place, on a terminal only.
Progress shown_progress(const Streams& streams);
// The same, and Ctrl C ends the work: it throws Cancelled.
Progress stoppable(const Streams& streams, const Interrupts& interrupts);
void clear_progress(const Streams& streams);

} // namespace trivar
