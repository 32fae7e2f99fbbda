// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

#include <filesystem>

namespace trivar {

// Whether a step names a file by a path relative to the scene's folder.
bool imports_by_relative_path(const History::Step& step);

// The history with the paths of imports rewritten for another folder.
History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to);

} // namespace trivar
