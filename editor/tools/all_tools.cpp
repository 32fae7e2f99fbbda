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
#include "ui/icons.h"

namespace trivar {

namespace {

// Makes a tool of what is said of it, and of what it shares with others.
template <class Made, class... With>
std::unique_ptr<Tool> tool(const char* name, const char* icon, const char* page,
                           const std::vector<ui::Chord>& keys, const char* help,
                           const With&... with)
{
    return std::make_unique<Made>(ToolFacts{name, icon, help, page, keys}, with...);
}

} // namespace

std::vector<std::unique_ptr<Tool>> all_tools()
{
    namespace icon = ui::icon;
    const auto handles = std::make_shared<HandleChoice>(HandleChoice::all);
    const auto choices = std::make_shared<TransformChoices>();
    const char* const motions = "move-rotate-scale";
    std::vector<std::unique_ptr<Tool>> t;
    t.push_back(tool<SelectTool>("Select", icon::select, "select", {{'Q'}, {'1'}},
                                 "Click an object to select it.", handles));
    t.push_back(tool<TransformTool>("Move", icon::move, motions, {{'G'}},
                                    "Drag an arrow, a plane or the middle.", MotionKind::move,
                                    choices));
    t.push_back(tool<TransformTool>("Rotate", icon::rotate, motions, {{'R'}},
                                    "Drag a ring round the selected objects.", MotionKind::rotate,
                                    choices));
    t.push_back(tool<TransformTool>("Scale", icon::scale, motions, {{'S'}},
                                    "Drag a box, a plane or the middle.", MotionKind::scale,
                                    choices));
    t.push_back(tool<PlaceTool>("Place", icon::place, "place", {{'D'}, {'2'}},
                                "Draw a stroke across the scene; the model lies along it.",
                                handles));
    t.push_back(tool<PressTool>("Press", icon::press, "press", {{'P'}, {'3'}},
                                "Push or pull a placed model with a soft ball."));
    t.push_back(tool<TilesTool>("Tiles", icon::tiles, "tiles", {{'T'}},
                                "Paint copies of the selected object onto a surface."));
    t.push_back(tool<MaskTool>("Mask", icon::mask, "tiles", {{'M'}},
                               "Let tiles fade along a line, round a point or round a curve."));
    t.push_back(tool<InciseTool>("Incise", icon::incise, "incise", {{'C'}},
                                 "Cut a skin open along a stroke, with flesh and depth inside."));
    t.push_back(
        tool<SplitTool>("Split", icon::split, "split", {{'K'}},
                        "Let an object part round obstacles, or cut it by a plane or a stroke."));
    t.push_back(tool<SilhouettesTool>(
        "Silhouettes", icon::silhouettes, "volumes", {{'L'}},
        "Draw the silhouettes of levels of volume data, and move the levels."));
    t.push_back(tool<LatticePointsTool>(
        "Lattice", icon::volume, "lattice", {{'V'}, {'4'}},
        "Move control points of a lattice, or of the volume of a placed model."));
    t.push_back(tool<TetrahedraTool>("Tetrahedra", icon::tetrahedra, "tetrahedra", {{'Y'}},
                                     "Pull, crease, cut and refine what stands in tetrahedra."));
    return t;
}

} // namespace trivar
