// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tool.h"

#include "editor/tools/place.h"
#include "editor/tools/select.h"

namespace trivar {

std::vector<std::unique_ptr<Tool>> all_tools()
{
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<SelectTool>());
    tools.push_back(std::make_unique<PlaceTool>());
    return tools;
}

} // namespace trivar
