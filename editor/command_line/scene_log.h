// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/evaluation/lacking.h"
#include "core/scene/files_read.h"
#include "core/scene/log.h"
#include "editor/command_line/interrupts.h"
#include "editor/command_line/status.h"

#include <map>

namespace trivar {

// What a command runs: the file, and other files than it names.
struct SceneLog {
    std::string path;
    std::vector<std::string> relinked; // NAME=FILE, as --set has it
    bool keep_going = false;           // without what it lacks
    bool overwrite = false;            // also files that it is made from
};

// NAME=FILE, as --set has it. Throws WrongUsage.
std::map<std::string, std::string> relinked_files(const std::vector<std::string>& settings);
Ref<AssetStore> asset_store(const SceneLog& scene);
// Whoever relinks a file means one that the scene names and one that is there. Throws Rejected.
void check_relinked(const SceneLog& scene, const Document& document);

// The files that what is written may not replace: none with --overwrite.
SourceFiles kept_sources(const SceneLog& scene, const Document& document, const AssetStore& assets);
// What a scene lacks ends a command, unless --keep-going was said. Throws IncompleteScene.
void check_whole(const SceneLog& scene, const Evaluation& evaluated, const Document& document);
void say_not_whole(const SceneLog& scene, const Streams& streams);

// Throws Rejected where a file that is to be written has the name of what is none.
void check_written(const std::vector<std::string>& paths);

// The text of an ordinary file. Throws Rejected.
std::string log_text(const SceneLog& scene);
// The lines of that text; a notice of it is said. Throws Rejected.
Log scene_log(const std::string& text, const std::string& path, const Streams& streams);

// One line of talk in place, on a terminal only.
Progress shown_progress(const Streams& streams);
// The same, and Ctrl C ends the work: it throws Cancelled.
Progress stoppable(const Streams& streams, const Interrupts& interrupts);
void clear_progress(const Streams& streams);

} // namespace trivar
