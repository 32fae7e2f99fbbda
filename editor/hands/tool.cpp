// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/tool.h"

#include "core/placement/shaping.h"
#include "editor/hands/helpers.h"
#include "editor/hands/parts_tool.h"

namespace trivar {

Helpers Tool::helpers(const Session&, const ui::Theme&) const
{
    return {};
}

std::vector<VolumePart> PartsTool::held(const Session&) const
{
    return {};
}

} // namespace trivar
