// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/level.h"

namespace trivar::gpu {

std::optional<Level> level_named(std::string_view name)
{
    for (std::size_t i = 0; i < level_names.size(); ++i)
        if (level_names[i] == name) return static_cast<Level>(i);
    return std::nullopt;
}

void set_level(Picture& picture, Level level)
{
    picture.draft = level == Level::draft;
    picture.samples = level == Level::high ? 16 : level == Level::standard ? 4 : 1;
}

} // namespace trivar::gpu
