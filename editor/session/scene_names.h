// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene_file.h"

#include <string>

namespace trivar {

// The title of the scene: its file's name, that of the file of which it is a copy, or untitled; and
// the same as the beginning of a new file's name.
std::string title_of(const SceneFile& scene);
std::string stem_of(const SceneFile& scene);

} // namespace trivar
