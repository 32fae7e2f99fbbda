// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <string>

namespace trivar {

// Copies every file that the document's models come from, with the files that go with them, into a
// folder, and returns the command that takes the models from there; nothing where all of them lie
// there already. What is there with the same content is taken as it is, with another content it
// stays and the copy gets another name. Throws Rejected (a file is missing, the disk is full) or
// Cancelled, and what was copied is gone again.
struct Collection {
    std::optional<Relink> command;
    std::size_t copied = 0, reused = 0; // files
};
Collection collect_files(const Document& document, const AssetStore& assets,
                         const std::string& folder, const Progress& progress = {});

} // namespace trivar
