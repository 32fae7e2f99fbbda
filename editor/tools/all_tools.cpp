// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/all_tools.h"

#include "editor/hands/select.h"
#include "editor/hands/transform.h"
#include "editor/tools/incise/incise.h"
#include "editor/tools/lattice/lattice_points.h"
#include "editor/tools/lattice/press.h"
#include "editor/tools/place/place.h"
#include "editor/tools/silhouettes/silhouettes.h"
#include "editor/tools/split/split.h"
#include "editor/tools/tetrahedra/tetrahedra.h"
#include "editor/tools/tiles/mask.h"
#include "editor/tools/tiles/tiles.h"

namespace trivar {

std::vector<std::unique_ptr<Tool>> all_tools()
{
    std::vector<std::unique_ptr<Tool>> tools;
    const auto handles = std::make_shared<HandleChoice>(HandleChoice::all);
    tools.push_back(std::make_unique<SelectTool>(handles));
    const auto choices = std::make_shared<TransformChoices>();
    for (const MotionKind kind : {MotionKind::move, MotionKind::rotate, MotionKind::scale})
        tools.push_back(std::make_unique<TransformTool>(kind, choices));
    tools.push_back(std::make_unique<PlaceTool>(handles));
    tools.push_back(std::make_unique<PressTool>());
    tools.push_back(std::make_unique<TilesTool>());
    tools.push_back(std::make_unique<MaskTool>());
    tools.push_back(std::make_unique<InciseTool>());
    tools.push_back(std::make_unique<SplitTool>());
    tools.push_back(std::make_unique<SilhouettesTool>());
    tools.push_back(std::make_unique<LatticePointsTool>());
    tools.push_back(std::make_unique<TetrahedraTool>());
    return tools;
}

} // namespace trivar
