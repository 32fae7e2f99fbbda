// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/objects/import.h"
#include "core/document/asset_store.h"

#include <optional>
#include <string>

namespace trivar {

// Copies every file from which the document's models come, with the files that these name, and
// every picture that a mask or heights read, and all files of volume data, into a folder, and
// returns the command that takes them from there; empty where all of them lie there already. A file
// of the same name and content in the folder is used as it is; one with other content stays, and
// the copy gets another name. Throws Rejected (a file is missing, the disk is full) or Cancelled,
// and the copies are removed again.
struct Collection {
    std::optional<Relink> command;
    std::size_t copied = 0, reused = 0; // files
};
Collection collect_files(const Document& document, const AssetStore& assets,
                         const std::string& folder, const Progress& progress = {});

} // namespace trivar
