// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/copies.h"
#include "core/scene/history.h"

#include <filesystem>
#include <optional>

namespace trivar {

// Whether a step of the history or of its branches names a file by a path relative to the scene's
// folder.
bool imports_by_relative_path(const History& history);

// The history with the paths of imports rewritten for another folder.
History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to);

// The same, for a file in another folder: the shapes that the scene kept while it had no name are
// copied along. One whose name another content has there takes the next free number. Empty where no
// path changes: then the very documents stay, and with them what was computed from them. Throws
// Rejected.
std::optional<History> moved_with_shapes(const History& history, const std::filesystem::path& from,
                                         const std::filesystem::path& to, Copies& copies);

} // namespace trivar
